// SPDX-License-Identifier: GPL-3.0-or-later
// [systems] of a plan: every condition on each of so many systems, which are drawn once from ranges of parameters.
//
// A Latin hypercube (McKay, Beckman & Conover 1979): of n systems one has its value in each n-th of a range, so that
// few systems cover it; in the logarithm where a range lies above 0. The systems depend on their own seed and not on
// the plan's: other lives on the same systems.
#pragma once

#include <string>
#include <vector>

#include "core/experiment/configuration.h"
#include "core/plans/plan_file.h"

namespace surefoot {

/// What one drawn system differs in, and the words in front of its conditions' names: "system 7: ".
struct DrawnSystem {
  std::string prefix;
  std::vector<Assignment> assignments;
};

/// Reads count (2 to 1,000), seed, and set.KEY = [low, high], and draws; empty without settings. An error names file
/// and line.
Result<std::vector<DrawnSystem>> drawSystems(const std::vector<PlanSetting>& settings, const std::string& path);

/// The number of systems that the settings ask for; 1 if there are none or they are wrong.
double systemsIn(const std::vector<PlanSetting>& settings);

/// "system 7: TRL 50" without its system, and the number of the system; 0: the name has none.
std::pair<int, std::string> systemOf(const std::string& conditionName);

}  // namespace surefoot
