// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/signals_line.h"

#include <CLI/CLI.hpp>

namespace surefoot {

SignalsLine::SignalsLine(CLI::App& app)
    : rollout(app.add_subcommand("rollout", "live what a Q-function has learned, and write every signal down")),
      robustness(app.add_subcommand("robustness", "how often what was learned falls, over pushes and models")) {
  RolloutRequest& r = rolloutRequest;
  rollout->add_option("FILE", r.file, "a Q-function")->type_name("");
  addOption(*rollout, "--seconds", r.seconds, "how long, in simulated seconds [25]", "T");
  addOption(*rollout, "--episodes", r.episodes, "at most so many episodes", "N");
  rollout->add_option("--policy", r.policy, "action-selection rule")->type_name("NAME")->capture_default_str();
  addOption(*rollout, "--seed", r.seed, "seed of starts and draws [1]", "N");
  addOption(*rollout, "--state", r.state, "the state that it begins in; else the environment draws one", "S1;S2;…");
  addOption(*rollout, "--scenario", r.scenario, "on another model than it was learned on", "NAME");
  addAssignments(*rollout, r.assignments, "a parameter of policy or environment; may be repeated");
  rollout->add_option("--push", r.pushes, "push the body at this time [s] by this impulse [N s]; may be repeated")
      ->type_name("T:IMPULSE")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
  addOption(*rollout, "--csv", r.csv, "write a row a step to this file, which must not exist yet", "FILE.csv");
  addOption(*rollout, "--npz", r.npz, "write an array a signal to this file for numpy.load", "FILE.npz");
  addOption(*rollout, "--film", r.film,
            "film it, 30 pictures a second of simulated time: .webp, or with the program ffmpeg .gif, .apng, .mp4, "
            ".webm",
            "FILE.webp");
  addOption(*rollout, "--size", r.size, "width and height of the film in pixels [960x540]", "WxH");
  addOption(*rollout, "--strips", r.strips,
            "signals below the film: keys with , between strips and + between signals of one; or usual", "KEYS");
  addOption(*rollout, "--appearance", r.appearance, "of the film: light or dark [light]", "NAME");
  rollout->add_flag("--json", r.json, "print the result as one JSON object");
  addRobustnessOptions();
}

void SignalsLine::addRobustnessOptions() {
  RobustnessRequest& r = robustnessRequest;
  RobustnessQuestion& q = r.question;
  robustness->add_option("FILE", r.file, "a Q-function")->type_name("");
  robustness->add_option("FILE2", r.second, "a second one of the same environment, beside it")->type_name("");
  addOption(*robustness, "--push", q.push, "impulses [N s], as 0..2:9 (nine from 0 to 2) or as 0;0.5;1 [0]", "VALUES");
  addOption(*robustness, "--push-at", q.pushAt, "when it is pushed [s], or between when a start draws it [0..5]",
            "T or T..T");
  addOption(*robustness, "--seconds", q.seconds, "how long it is followed from the push on [10]", "T");
  addOption(*robustness, "--scenario", q.scenario, "models: scenarios by name, or all [as it was learned]", "NAMES");
  robustness
      ->add_option("--set", q.settings,
                   "models: a parameter of the environment with its values, as environment.friction=0..0.1:5; "
                   "several multiply. Or one value of the policy's")
      ->type_name("KEY=VALUES")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
  robustness->add_option("--policy", q.policy, "action-selection rule")->type_name("NAME")->capture_default_str();
  addOption(*robustness, "--starts", q.starts, "trials of every push on every model [100]", "N");
  addOption(*robustness, "--seed", q.seed, "seed of starts and draws [1]", "N");
  addOption(*robustness, "--jobs", r.jobs, "threads [all cores]", "N");
  addOption(*robustness, "--csv", r.csv, "write a row a cell to this file, which must not exist yet", "FILE.csv");
  robustness->add_flag("--json", r.json, "print the result as one JSON object");
}

std::optional<Result<Request>> SignalsLine::request() const {
  if (rollout->parsed()) return Result<Request>(rolloutRequest);
  if (robustness->parsed()) return Result<Request>(robustnessRequest);
  return std::nullopt;
}

}  // namespace surefoot
