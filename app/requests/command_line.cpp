// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/requests/follow_line.h"
#include "app/requests/laboratory_line.h"
#include "app/requests/lessons_line.h"
#include "app/requests/requests.h"
#include "app/requests/robots_line.h"
#include "app/requests/signals_line.h"
#include "core/environment_programs.h"
#include "core/text/text.h"
#include "core/text/words.h"
#include "core/version.h"

namespace surefoot {

namespace {

void addTrainOptions(CLI::App& app, TrainOptions& o) {
  const auto choice = [&](const char* name, std::optional<std::string>& value, const std::string& help,
                          const std::string& usual = "") {
    addOption(app, name, value, (usual.empty() ? help : fmt::format("{} [{}]", help, usual)).c_str(), "NAME");
  };
  const Names usual;
  choice("--environment", o.names.environment, "what to learn in", usual.environment);
  choice("--preset", o.names.preset, "constants of the environment: thesis (the default) or lab");
  choice("--scenario", o.names.scenario, "deviation from the actual system: actual (the default), 1 … 6");
  choice("--agent", o.names.agent, "learning rule", usual.agent);
  choice("--features", o.names.features, "representation of the state", usual.features);
  choice("--policy", o.names.policy, "action-selection rule", usual.policy);
  addAssignments(app, o.assignments, "a parameter, e.g. policy.temperature=1; may be repeated");
  app.add_option_function<std::string>(
         "--rewind", [&o](const std::string& steps) { o.assignments.push_back("life.rewind=" + steps); },
         "after a fall go back so many steps and live on, for simulations (life.rewind)")
      ->type_name("N");
  addOption(app, "--seed", o.seed, "master seed, 0 to 18446744073709551615 [1]", "N");
  addOption(app, "--minutes", o.minutes, "length of a life in simulated minutes", "T");
  addOption(app, "--episodes", o.episodes, "length of a life in episodes; whichever comes first ends it", "N");
  addOption(app, "--until", o.until, "end a life when the average reward of 80 episodes reaches this", "REWARD");
  addOption(app, "--lives", o.lives, "number of lives [1]", "N");
  addOption(app, "--jobs", o.jobs, "threads [all cores]", "N");
  app.add_flag("--json", o.json, "print the result as one JSON object");
  addOption(app, "--log", o.log, "write a row an episode to this file, which must not exist yet", "FILE.csv");
  app.add_flag("--load-from-other", o.loadFromOther,
               "with --load and --environment: even if it was learned on a robot of another name, whose states and "
               "actions must be the same");
  addOption(app, "--load", o.load,
            "begin with what another life has learned, under its configuration; other options come on top", "FILE");
  addOption(app, "--from", o.from, "live as a journal, a saved session or a Q-function says; other options come on top",
            "FILE");
  app.add_option("--at", o.at,
                 "do this when the life has taken so many steps: a parameter, policy=NAME, push=IMPULSE, place=STATE")
      ->type_name("STEP:KEY=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
}

void addFileOptions(CLI::App& app, TrainOptions& o) {
  addOption(app, "--save", o.save, "write what was learned to this file, which must not exist yet", "FILE");
  addOption(app, "--journal", o.journal, "write what was done to the life, for `surefoot replay`", "FILE");
  addOption(app, "--checkpoint", o.checkpoint, "write the whole life to this file, again and again", "FILE");
  addOption(app, "--every", o.every, "simulated minutes between two checkpoints [10]", "T");
  addOption(app, "--resume", o.resume, "go on from a checkpoint", "FILE");
  app.add_flag("--other-version", o.otherVersion, "with --resume: even if a version lived it whose lives are others");
}

/// The first word that no option or command knows, with the nearest that one does.
Error unexpected(const CLI::App& app, const CLI::App& train, const std::string& word) {
  const bool option = word.starts_with('-');
  const bool top = app.get_parent() == nullptr;
  const std::string name = word.substr(0, word.find('='));
  const auto optionsOf = [](const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* o : command.get_options()) names.push_back(o->get_name());
    return names;
  };
  std::vector<std::string> known;
  if (option) known = optionsOf(app);
  if (!option && top)
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
      known.push_back(command->get_name());
  if (option && top) {
    const auto behind = optionsOf(train);
    if (std::find(behind.begin(), behind.end(), name) != behind.end())
      return Error{fmt::format("{}: it stands behind a command, as in `surefoot train {} …` or `surefoot window {} …`.",
                               name, name, name)};
  }
  const std::string near = nearestWord(name, known);
  const char* what = option ? "there is no such option" : top ? "there is no such command" : "nothing is expected here";
  return Error{fmt::format("\"{}\": {}{}; see `surefoot{} --help`.", shortened(name), what,
                           near.empty() ? "" : ", did you mean " + near, top ? "" : " " + app.get_name())};
}

/// CLI11's error, in one sentence.
Error plain(const CLI::ParseError& error) {
  std::string text = error.what();
  const std::string option = text.substr(0, text.find(':'));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) {
    const bool twice = text.find("At Most") != std::string::npos || text.find("Exactly") != std::string::npos;
    return Error{option + (twice ? ": it is given more than once; give it once." : ": a value is needed behind it.")};
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
  return Error{text.ends_with('.') ? text : text + "."};
}

/// `--log --json` is a forgotten file name, not a file called "--json".
Status checkSwallowed(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    for (const std::string& value : option->results())
      if (value.starts_with("--"))
        return Error{
            fmt::format("{}: a value is needed behind it, not the option {}.", option->get_name(), shortened(value))};
  return Done{};
}

/// The program's commands and options, bound to the texts that they were given.
struct CommandLine {
  CLI::App app{"Surefoot: reinforcement learning that avoids falling. Without a command it opens the window.",
               "surefoot"};
  CLI::App* train = app.add_subcommand("train", "learn without a window: one life, or many on all cores");
  CLI::App* window = app.add_subcommand("window", "open the workbench, with the options of train");
  CLI::App* list = app.add_subcommand("list", "name everything that can be chosen or set");
  CLI::App* query = app.add_subcommand("query", "what a Q-function holds about one state");
  CLI::App* slice = app.add_subcommand("slice", "a plane through a Q-function, as CSV");
  CLI::App* inspect = app.add_subcommand("inspect", "what a file holds and where it comes from");
  CLI::App* resample = app.add_subcommand("resample", "carry a Q-function over into another resolution");
  CLI::App* replay = app.add_subcommand("replay", "live a journal again");
  CLI::App* difference = app.add_subcommand("difference", "the first step at which two lives differ, and in what");
  CLI::App* bench = app.add_subcommand("bench", "how fast this machine learns");
  CLI::App* probabilities = app.add_subcommand("probabilities", "the probability of every action, given its value");
  LessonsLine lessons{app, *window};
  FollowLine follow{*window};
  RobotsLine robots{app};
  SignalsLine signals{app};
  LaboratoryLine laboratory{app};
  TrainOptions trainOptions, windowOptions;
  ListRequest listOptions;
  ProbabilitiesOptions probabilitiesOptions;
  QueryRequest queryOptions;
  SliceRequest sliceOptions;
  InspectRequest inspectOptions;
  ResampleRequest resampleOptions;
  ReplayRequest replayOptions;
  DifferenceRequest differenceOptions;
  BenchRequest benchOptions;

  /// Those that let an environment move.
  std::vector<CLI::App*> livingCommands() const {
    std::vector<CLI::App*> all = laboratory.livingCommands();
    all.insert(all.end(), {train, window, replay, difference, robots.check, signals.rollout, signals.robustness});
    return all;
  }

  CommandLine() {
    app.require_subcommand(0, 1);
    addTrainOptions(*train, trainOptions);
    addTrainOptions(*window, windowOptions);
    addFileOptions(*train, trainOptions);
    addFileCommands();
    window->add_flag("--turbo", windowOptions.turbo, "learn flat out from the start");
    list->add_flag("--json", listOptions.json, "as JSON");
    list->add_option("ROBOT", listOptions.robot,
                     "a robot's file, or the name of one that comes with the program: "
                     "what can be set and chosen of it")
        ->type_name("");
    addOption(*probabilities, "--q", probabilitiesOptions.q, "action values, separated by ; or blanks, or by commas",
              "Q1;Q2;…");
    probabilities->add_option("--policy", probabilitiesOptions.policy, "action-selection rule")
        ->type_name("NAME")
        ->capture_default_str();
    addAssignments(*probabilities, probabilitiesOptions.assignments, "a parameter of the policy; may be repeated");
    probabilities->add_flag("--json", probabilitiesOptions.json, "as JSON");
    std::vector<CLI::App*> commands = laboratory.commands();
    for (CLI::App* c : {&app, train, window, list, probabilities, query, slice, inspect, resample, replay, difference,
                        bench, lessons.lessons, robots.check, robots.create, signals.rollout, signals.robustness})
      commands.push_back(c);
    for (CLI::App* command : commands) {
      command->set_help_flag("-h,--help", "print this help");
      command->set_version_flag("--version", std::string("surefoot ") + kVersion, "print the version");
      command->allow_extras();
    }
  }

  void addFileCommands() {
    const auto file = [](CLI::App* command, std::string& path, const char* what) {
      command->add_option("FILE", path, what)->type_name("");
    };
    file(query, queryOptions.file, "a Q-function");
    addOption(*query, "--state", queryOptions.state, "the state, its variables separated by ; or blanks, or by commas",
              "S1;S2;…");
    addOption(*query, "--policy", queryOptions.policy, "action-selection rule, if not the file's", "NAME");
    addAssignments(*query, queryOptions.assignments, "a parameter of the policy; may be repeated");
    query->add_flag("--json", queryOptions.json, "as JSON");

    file(slice, sliceOptions.file, "a Q-function");
    addOption(*slice, "--axes", sliceOptions.axes, "the two state variables that vary", "VARIABLE,VARIABLE");
    addOption(*slice, "--at", sliceOptions.at, "the state that the plane goes through [0;0;…]", "S1;S2;…");
    addOption(*slice, "--points", sliceOptions.points, "points along each axis [101]", "N");
    addOption(*slice, "--out", sliceOptions.out, "the table to write, which must not exist yet", "FILE.csv");

    file(inspect, inspectOptions.file, "a Q-function or a checkpoint");
    inspect->add_flag("--json", inspectOptions.json, "as JSON");

    file(resample, resampleOptions.file, "a Q-function");
    addAssignments(*resample, resampleOptions.assignments, "a parameter of the representation; may be repeated");
    addOption(*resample, "--save", resampleOptions.save, "the file to write, which must not exist yet", "FILE");
    resample->add_flag("--json", resampleOptions.json, "report as JSON");

    bench->add_flag("--json", benchOptions.json, "as JSON");
    file(replay, replayOptions.file, "a journal");
    replay->add_flag("--verify", replayOptions.verify, "fail unless the hash is that of the journal");
    replay->add_flag("--json", replayOptions.json, "print the result as one JSON object");

    const char* kinds = "a journal, a checkpoint (or session), or a log of lives";
    difference->add_option("FIRST", differenceOptions.first, kinds)->type_name("");
    difference->add_option("SECOND", differenceOptions.second, "another of the same kind")->type_name("");
    difference->add_flag("--json", differenceOptions.json, "as JSON");
  }

  /// An error for words that no option takes, or for an option that took a word not meant for it.
  Status checkLeftovers() const {
    const auto chosen = app.get_subcommands();
    if (const auto extras = app.remaining(false); !extras.empty()) return unexpected(app, *train, extras.front());
    if (chosen.empty()) return Done{};
    if (const Status s = checkSwallowed(*chosen.front()); !s) return s;
    const auto extras = chosen.front()->remaining(false);
    return extras.empty() ? Status(Done{}) : Status(unexpected(*chosen.front(), *train, extras.front()));
  }
};

/// A checked request of one kind as a request of any.
template <class R>
Result<Request> any(Result<R> request) {
  if (!request) return request.error();
  return Request(std::move(*request));
}

}  // namespace

Result<Request> parseCommandLine(const Registry& registry, int argc, char** argv) {
  CommandLine line;
  for (CLI::App* command : line.livingCommands())
    command->add_flag_callback(
        "--allow-programs", [&] { registry.programs->allowAll(); },
        "robots may start the programs that their files name");
  try {
    line.app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Request(PrintRequest{line.app.help()});
  } catch (const CLI::CallForVersion&) {
    return Request(PrintRequest{std::string("surefoot ") + kVersion + "\n"});
  } catch (const CLI::ParseError& error) {
    return plain(error);
  }
  if (const Status s = line.checkLeftovers(); !s) return s.error();

  if (auto request = line.laboratory.request(registry)) return std::move(*request);
  if (auto request = line.robots.request()) return std::move(*request);
  if (auto request = line.signals.request()) return std::move(*request);
  if (line.list->parsed()) return Request(line.listOptions);
  if (line.train->parsed()) return any(makeTrainRequest(registry, line.trainOptions, false));
  if (line.probabilities->parsed()) return any(makeProbabilitiesRequest(registry, line.probabilitiesOptions));
  if (line.query->parsed()) return Request(line.queryOptions);
  if (line.slice->parsed()) return Request(line.sliceOptions);
  if (line.inspect->parsed()) return Request(line.inspectOptions);
  if (line.resample->parsed()) return Request(line.resampleOptions);
  if (line.bench->parsed()) return Request(line.benchOptions);
  if (line.replay->parsed()) return Request(line.replayOptions);
  if (line.difference->parsed()) return Request(line.differenceOptions);
  if (line.lessons.lessons->parsed()) return Request(line.lessons.request);
  if (const Status s = line.follow.check(); !s) return s.error();
  auto request = makeTrainRequest(registry, line.windowOptions, true);
  if (!request) return request.error();
  WindowRequest shown{std::move(*request)};
  shown.follow = line.follow.follow;
  if (const Status s = line.lessons.complete(shown); !s) return s.error();
  return Request(std::move(shown));
}

}  // namespace surefoot
