// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/process/exit_code.h"
#include "app/requests/declared_commands.h"
#include "app/requests/examples.h"
#include "app/requests/laboratory_line.h"
#include "app/requests/lessons_line.h"
#include "app/requests/line_errors.h"
#include "app/requests/open_line.h"
#include "app/requests/requests.h"
#include "app/requests/robots_line.h"
#include "app/requests/signals_line.h"
#include "core/basics/version.h"
#include "core/environment_programs.h"

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
  CLI::App* handbook = app.add_subcommand("handbook", "write the handbook as web pages");
  LessonsLine lessons{app, *window};
  CLI::App* manual = app.add_subcommand("manual", "write the manual pages")->group("");
  OpenLine open{*window};
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
  ManualRequest manualOptions;
  bool versionAsJson = false;
  HandbookRequest handbookOptions;

  /// Those that let an environment move.
  std::vector<CLI::App*> livingCommands() const {
    std::vector<CLI::App*> all = laboratory.livingCommands();
    all.insert(all.end(), {train, window, replay, difference, robots.check, signals.rollout, signals.robustness});
    return all;
  }

  explicit CommandLine(const Registry& registry) {
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
    for (CLI::App* c :
         {&app, train, window, list, probabilities, query, slice, inspect, resample, replay, difference, bench,
          handbook, lessons.lessons, robots.check, robots.create, signals.rollout, signals.robustness})
      commands.push_back(c);
    for (CLI::App* command : commands) {
      command->set_help_flag("-h,--help", "print this help");
      command->set_version_flag("--version", std::string("surefoot ") + kVersion, "print the version");
      command->allow_extras();
      if (const std::string examples = examplesText(command->get_name()); !examples.empty())
        command->footer(examples + command->get_footer());
    }
    for (CLI::App* command : livingCommands())
      command->add_flag_callback(
          "--allow-programs", [&registry] { registry.programs->allowAll(); },
          "robots may start the programs that their files name");
    app.add_flag("--json", versionAsJson, "with --version: as JSON, with the versions of all libraries");
    app.footer(exitCodesText());
    manual->add_option("FOLDER", manualOptions.folder, "the folder to write them to");
    manual->add_option("DATE", manualOptions.date, "the date that they bear");
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

    handbook->add_option("FOLDER", handbookOptions.folder, "the folder to make; it must not exist yet")->type_name("");
    handbook->add_option("--language", handbookOptions.language, "of the pages: en, nl or de [en]")->type_name("CODE");
    bench->add_flag("--json", benchOptions.json, "as JSON");
    file(replay, replayOptions.file, "a journal");
    replay->add_flag("--verify", replayOptions.verify, "fail unless the hash is that of the journal");
    replay->add_flag("--json", replayOptions.json, "print the result as one JSON object");

    const char* kinds = "a journal, a checkpoint (or session), or a log of lives";
    difference->add_option("FIRST", differenceOptions.first, kinds)->type_name("");
    difference->add_option("SECOND", differenceOptions.second, "another of the same kind")->type_name("");
    difference->add_flag("--json", differenceOptions.json, "as JSON");
  }

  /// Whether --json stands anywhere, whatever else there is.
  bool asksForJson() const {
    const auto has = [](const CLI::App& command) {
      const CLI::Option* json = command.get_option_no_throw("--json");
      return json && json->count() > 0;
    };
    const auto commands = app.get_subcommands();
    return has(app) || std::any_of(commands.begin(), commands.end(), [&](const CLI::App* c) { return has(*c); });
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

std::vector<DeclaredCommand> declaredCommands(const Registry& registry) {
  return declaredIn(CommandLine(registry).app);
}

Result<Request> parseCommandLine(const Registry& registry, int argc, char** argv) {
  CommandLine line(registry);
  std::vector<std::string> words(argv + 1, argv + argc);
  const bool command =
      words.empty() || !line.app.get_subcommands([&](const CLI::App* c) { return c->get_name() == words[0]; }).empty();
  if (!command && OpenLine::isFile(words[0])) words.insert(words.begin(), "window");
  std::reverse(words.begin(), words.end());  // as CLI11 wants them
  try {
    line.app.parse(words);
  } catch (const CLI::CallForHelp&) {
    return Request(PrintRequest{line.app.help()});
  } catch (const CLI::CallForVersion&) {
    return Request(VersionRequest{line.asksForJson()});
  } catch (const CLI::ParseError& error) {
    return plain(error);
  }
  if (const Status s = line.checkLeftovers(); !s) return s.error();
  if (line.versionAsJson)
    return Error{"--json: in front of a command it goes with --version; behind one it is the command's."};
  if (line.manual->parsed()) return Request(line.manualOptions);

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
  if (line.handbook->parsed()) {
    const std::vector<std::string>& codes = OpenLine::languages();
    if (std::find(codes.begin(), codes.end(), line.handbookOptions.language) == codes.end())
      return unknownName("--language", line.handbookOptions.language, codes);
    return Request(line.handbookOptions);
  }
  if (line.lessons.lessons->parsed()) return Request(line.lessons.request);
  if (const Status s = line.open.check(); !s) return s.error();
  auto request = makeTrainRequest(registry, line.windowOptions, true);
  if (!request) return request.error();
  WindowRequest shown{std::move(*request)};
  line.open.complete(shown);
  if (const Status s = line.lessons.complete(shown); !s) return s.error();
  return Request(std::move(shown));
}

}  // namespace surefoot
