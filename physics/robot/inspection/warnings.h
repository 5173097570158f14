// SPDX-License-Identifier: GPL-3.0-or-later
// What is doubtful about a robot after it has moved at random and by itself.
#pragma once

#include <set>
#include <vector>

#include "core/environment.h"
#include "core/environment_inspection.h"
#include "physics/robot/spec/robot_spec.h"

namespace surefoot {

inline constexpr int kInspectedSteps = 4000;

/// Of the random life.
struct RandomLifeSeen {
  std::vector<std::vector<double>> states{};  ///< of every step
  std::set<std::vector<double>> starts{};
  std::vector<bool> rewarded{};  ///< whether each reward was ever other than 0
  int atOnce = 0, episodes = 0;  ///< episodes that ended in their first step, and all
};

/// Adds to `found`, in the order of the text.
void addWarnings(const RobotSpec& spec, const Task& task, const RandomLifeSeen& seen, EnvironmentInspection& found);

}  // namespace surefoot
