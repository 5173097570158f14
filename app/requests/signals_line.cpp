// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/signals_line.h"

#include <CLI/CLI.hpp>

namespace surefoot {

SignalsLine::SignalsLine(CLI::App& app)
    : rollout(app.add_subcommand("rollout", "live what a Q-function has learned, and write every signal down")) {
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
  rollout->add_flag("--json", r.json, "print the result as one JSON object");
}

std::optional<Result<Request>> SignalsLine::request() const {
  if (rollout->parsed()) return Result<Request>(rolloutRequest);
  return std::nullopt;
}

}  // namespace surefoot
