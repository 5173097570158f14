// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `rollout` and `robustness`: what a Q-function does.
#pragma once

#include "app/requests/laboratory_line.h"

namespace surefoot {

struct SignalsLine {
  explicit SignalsLine(CLI::App& app);

  CLI::App *rollout, *robustness;
  RolloutRequest rolloutRequest;
  RobustnessRequest robustnessRequest;

  /// Nothing: none of these commands was given.
  std::optional<Result<Request>> request() const;

 private:
  void addRobustnessOptions();
};

}  // namespace surefoot
