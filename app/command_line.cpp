// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <limits>
#include <thread>

#include "app/version.h"

namespace surefoot {

namespace {

/// The options of `train` and `window`, as they were written.
struct TrainOptions {
  Names names;
  std::vector<std::string> assignments;
  std::optional<std::string> seed, minutes, episodes, lives, jobs, log;
  bool json = false, turbo = false;
};

void addOption(CLI::App& app, const std::string& name, std::optional<std::string>& value, const std::string& help,
               const std::string& type) {
  app.add_option_function<std::string>(
         name, [&value](const std::string& text) { value = text; }, help)
      ->type_name(type);
}

void addTrainOptions(CLI::App& app, TrainOptions& o) {
  const auto choice = [&](const char* name, std::string& value, const char* help) {
    app.add_option(name, value, help)->type_name("NAME")->capture_default_str();
  };
  choice("--environment", o.names.environment, "what to learn in");
  choice("--preset", o.names.preset, "constants of the environment");
  choice("--scenario", o.names.scenario, "deviation from the actual system: actual, 1 … 6");
  choice("--agent", o.names.agent, "learning rule");
  choice("--features", o.names.features, "representation of the state");
  choice("--policy", o.names.policy, "action-selection rule");
  app.add_option("--set", o.assignments, "a parameter, e.g. policy.temperature=1; may be repeated")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  addOption(app, "--seed", o.seed, "master seed, 0 to 18446744073709551615 [1]", "N");
  addOption(app, "--minutes", o.minutes, "length of a life in simulated minutes", "T");
  addOption(app, "--episodes", o.episodes, "length of a life in episodes; whichever comes first ends it", "N");
  addOption(app, "--lives", o.lives, "number of lives [1]", "N");
  addOption(app, "--jobs", o.jobs, "threads [all cores]", "N");
  app.add_flag("--json", o.json, "print the result as one JSON object");
  addOption(app, "--log", o.log, "write a row an episode to this file, which must not exist yet", "FILE.csv");
}

Result<std::int64_t> parseCount(const std::string& option, const std::string& text, std::int64_t most) {
  std::int64_t value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code == std::errc{} && end == text.data() + text.size() && value >= 1 && value <= most) return value;
  return Error{fmt::format("{}: \"{}\" is not allowed; it takes a whole number from 1 to {}.", option,
                           text.substr(0, 60), most)};
}

Result<std::uint64_t> parseSeed(const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code == std::errc{} && end == text.data() + text.size()) return value;
  return Error{fmt::format("--seed: \"{}\" is not allowed; it takes a whole number from 0 to {}.", text.substr(0, 60),
                           std::numeric_limits<std::uint64_t>::max())};
}

Result<std::vector<Assignment>> parseAssignments(const std::vector<std::string>& texts) {
  std::vector<Assignment> assignments;
  for (const std::string& text : texts) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
      return Error{fmt::format("--set: \"{}\" is not KEY=VALUE, such as policy.epsilon=0.05.", text.substr(0, 60))};
    assignments.push_back({text.substr(0, equals), text.substr(equals + 1)});
    for (std::size_t i = 0; i + 1 < assignments.size(); ++i)
      if (assignments[i].key == assignments.back().key && assignments[i].value != assignments.back().value)
        return Error{fmt::format("--set: {} is given twice, as {} and as {}; give it once.", assignments[i].key,
                                 assignments[i].value, assignments.back().value)};
  }
  return assignments;
}

/// A key of a policy that is not the chosen one would have no effect: a slip worth a word.
Status checkPolicyKeys(const Registry& registry, const std::string& policy,
                       const std::vector<Assignment>& assignments) {
  const auto chosen = findEntry(registry.policies, "--policy", policy);
  if (!chosen) return chosen.error();
  const std::vector<std::string> used = policyKeys(**chosen);
  for (const Assignment& a : assignments) {
    if (!a.key.starts_with("policy.") || std::find(used.begin(), used.end(), a.key) != used.end()) continue;
    std::vector<std::string> owners;
    for (const PolicyEntry& entry : registry.policies) {
      const auto keys = policyKeys(entry);
      if (std::find(keys.begin(), keys.end(), a.key) != keys.end()) owners.push_back(entry.name);
    }
    if (!owners.empty())
      return Error{
          fmt::format("{}: the policy {} does not use it; it belongs to {}.", a.key, policy, joinWords(owners))};
  }
  return Done{};
}

Result<TrainRequest> makeTrainRequest(const Registry& registry, const TrainOptions& o, bool window) {
  const auto assignments = parseAssignments(o.assignments);
  if (!assignments) return assignments.error();
  if (!window)
    if (const Status s = checkPolicyKeys(registry, o.names.policy, *assignments); !s) return s.error();
  auto configuration = configure(registry, o.names, *assignments);
  if (!configuration) return configuration.error();

  TrainRequest request{.configuration = std::move(*configuration), .json = o.json, .log = o.log, .turbo = o.turbo};
  Configuration& c = request.configuration;
  if (o.seed) {
    const auto seed = parseSeed(*o.seed);
    if (!seed) return seed.error();
    c.seed = *seed;
  }
  if (o.minutes) {
    const Parameter minutes{.key = "--minutes", .low = 0.001, .high = 1e6};
    const auto value = parseValue(minutes, *o.minutes);
    if (!value) return value.error();
    c.minutes = *value;
  }
  if (o.episodes) {
    const auto value = parseCount("--episodes", *o.episodes, 1'000'000'000);
    if (!value) return value.error();
    c.episodes = *value;
  }
  const auto lives = o.lives ? parseCount("--lives", *o.lives, 1'000'000) : Result<std::int64_t>(1);
  if (!lives) return lives.error();
  c.lives = static_cast<int>(*lives);
  const std::int64_t cores = std::max(1u, std::thread::hardware_concurrency());
  const auto jobs = o.jobs ? parseCount("--jobs", *o.jobs, 1024) : Result<std::int64_t>(cores);
  if (!jobs) return jobs.error();
  request.jobs = static_cast<int>(*jobs);

  if (window && c.lives > 1)
    return Error{fmt::format("--lives: the window shows one life, not {}; `surefoot train` runs many.", c.lives)};
  if (!window && !c.minutes && !c.episodes)
    return Error{"--minutes or --episodes: how long a life is must be given, e.g. --minutes 9."};
  if (const auto life = makeLife(registry, c, 0, false); !life) return life.error();  // what no single check can see
  return request;
}

Result<std::vector<double>> parseQ(const std::string& text) {
  std::vector<double> q;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto value =
        parseNumber(fmt::format("--q, value {}", q.size() + 1), std::string_view(text).substr(begin, end - begin));
    if (!value)
      return text.empty() ? Error{"--q: the list is empty; action values are needed, such as 1,2,3."} : value.error();
    q.push_back(*value);
    begin = end + 1;
  }
  if (q.size() > kMaxActions)
    return Error{fmt::format("--q: {} values are given; 1 to {} are allowed.", q.size(), kMaxActions)};
  return q;
}

/// The first word that no option knows, with the nearest that one does.
Error unexpected(const CLI::App& app, const std::string& word) {
  std::vector<std::string> known;
  if (word.starts_with('-')) {
    for (const CLI::Option* option : app.get_options()) known.push_back(option->get_name());
  } else {
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
      known.push_back(command->get_name());
  }
  const std::string name = word.substr(0, word.find('='));
  const std::string near = nearestWord(name, known);
  return Error{fmt::format("{}: there is no such {}{}; see `surefoot{} --help`.", name.substr(0, 60),
                           word.starts_with('-') ? "option" : "command", near.empty() ? "" : ", did you mean " + near,
                           app.get_parent() ? " " + app.get_name() : "")};
}

std::string oneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.ends_with('.') ? text : text + ".";
}

}  // namespace

Result<Request> parseCommandLine(const Registry& registry, int argc, char** argv) {
  CLI::App app{"Surefoot: reinforcement learning that avoids falling. Without a command it opens the window.",
               "surefoot"};
  app.set_version_flag("--version", std::string("surefoot ") + kVersion, "print the version");
  app.set_help_flag("-h,--help", "print this help");
  app.require_subcommand(0, 1);

  TrainOptions trainOptions, windowOptions;
  ListRequest list;
  ProbabilitiesRequest probabilities;
  std::optional<std::string> q;
  std::string policy = "epsilon-greedy";
  std::vector<std::string> assignments;

  CLI::App* trainCommand = app.add_subcommand("train", "learn without a window: one life, or many on all cores");
  addTrainOptions(*trainCommand, trainOptions);
  CLI::App* windowCommand = app.add_subcommand("window", "open the workbench, with the options of train");
  addTrainOptions(*windowCommand, windowOptions);
  windowCommand->add_flag("--turbo", windowOptions.turbo, "learn flat out from the start");
  CLI::App* listCommand = app.add_subcommand("list", "name everything that can be chosen or set");
  listCommand->add_flag("--json", list.json, "as JSON");
  CLI::App* probabilitiesCommand =
      app.add_subcommand("probabilities", "the probability of every action, given its value");
  addOption(*probabilitiesCommand, "--q", q, "action values, separated by commas", "Q1,Q2,…");
  probabilitiesCommand->add_option("--policy", policy, "action-selection rule")
      ->type_name("NAME")
      ->capture_default_str();
  probabilitiesCommand->add_option("--set", assignments, "a parameter of the policy")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  probabilitiesCommand->add_flag("--json", probabilities.json, "as JSON");
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    command->set_help_flag("-h,--help", "print this help");
    command->set_version_flag("--version", std::string("surefoot ") + kVersion, "print the version");
    command->allow_extras();
  }
  app.allow_extras();

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Request(PrintRequest{app.help()});
  } catch (const CLI::CallForVersion&) {
    return Request(PrintRequest{std::string("surefoot ") + kVersion + "\n"});
  } catch (const CLI::ParseError& error) {
    return Error{oneLine(error.what())};
  }

  const auto chosen = app.get_subcommands();
  if (const auto extras = app.remaining(false); !extras.empty()) return unexpected(app, extras.front());
  if (!chosen.empty())
    if (const auto extras = chosen.front()->remaining(false); !extras.empty())
      return unexpected(*chosen.front(), extras.front());

  if (!chosen.empty() && chosen.front() == listCommand) return Request(list);
  if (!chosen.empty() && chosen.front() == trainCommand) {
    auto request = makeTrainRequest(registry, trainOptions, false);
    if (!request) return request.error();
    return Request(std::move(*request));
  }
  if (!chosen.empty() && chosen.front() == probabilitiesCommand) {
    if (!q) return Error{"--q: action values are needed, such as --q 1,2,3."};
    const auto values = parseQ(*q);
    if (!values) return values.error();
    const auto sets = parseAssignments(assignments);
    if (!sets) return sets.error();
    if (const Status s = checkPolicyKeys(registry, policy, *sets); !s) return s.error();
    probabilities.q = *values;
    probabilities.policy = policy;
    probabilities.assignments = *sets;
    return Request(std::move(probabilities));
  }
  auto request = makeTrainRequest(registry, windowOptions, true);
  if (!request) return request.error();
  return Request(WindowRequest{std::move(*request)});
}

}  // namespace surefoot
