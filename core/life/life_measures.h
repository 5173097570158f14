// SPDX-License-Identifier: GPL-3.0-or-later
// The measures of a whole life that follow from the measures of its task: their names, and how a person reads them.
#pragma once

#include <string>
#include <vector>

#include "core/environment.h"

namespace surefoot {

struct LifeMeasure {
  std::string name;    ///< in files and plans: "greedy_distance"
  std::string title;   ///< "distance of a greedy test, last 10"
  std::string unit;    ///< "m"
  bool ofGreedyTests;  ///< a life has it only if its task is tested

  /// "distance of a greedy test, last 10 [m]"
  std::string titleWithUnit() const { return unit.empty() ? title : title + " [" + unit + "]"; }
};

/// For every measure KEY of a task: KEY, over all episodes, and greedy_KEY, its mean over the last ten greedy tests.
/// Besides falls_per_hour; greedy_reward and greedy_falls; walks_after, the simulated minutes up to the first greedy
/// test in which the robot walked. Empty for a task without measures.
std::vector<LifeMeasure> lifeMeasures(const std::vector<TaskMeasure>& measures);

/// The total of a life that goes on with an episode of value `next`; `first`: it is the first.
double together(TaskMeasure::OfALife what, double before, double next, bool first);
/// The value over all episodes of a life; NaN if it needs an episode and there is none. `total`: from
/// LifeTotals::measures.
double valueOfALife(const TaskMeasure& measure, double total, std::int64_t episodes);

}  // namespace surefoot
