// SPDX-License-Identifier: GPL-3.0-or-later
// The contents of a value map: a quantity, the two state variables of its axes, and how the others are treated.
#pragma once

#include <QString>
#include <span>
#include <vector>

#include "core/environment.h"
#include "ui/live/maps/value_map.h"
#include "ui/running/task_words.h"

namespace surefoot {

enum class MapQuantity { BestAction, OneAction, GreedyAction, Risk, Visits, Eligibility };

/// A state variable that is no axis: it follows the live state, stands still, or is projected away.
enum class Across { Live, Fixed, Projected };
enum class Projection { Mean, Least, Most };

struct MapChoice {
  MapQuantity quantity = MapQuantity::BestAction;
  Action action = 0;  ///< OneAction: the action. GreedyAction: the action variable, if actions are combinations
  int x = 0, y = 1;
  std::vector<Across> across;  ///< one per state variable; entries of the two axes are ignored
  std::vector<double> fixed;   ///< one value per state variable, for the fixed ones
  Projection projection = Projection::Mean;
  bool locked = true;  ///< the colours span all possible returns; false: the values on the map

  /// Sets the usual choice for a task.
  void fit(const Task& task);
  /// Whether the task has all that was chosen.
  bool suits(const Task& task) const;
  bool isAxis(std::size_t variable) const { return static_cast<int>(variable) == x || static_cast<int>(variable) == y; }
  /// The slice through a live state.
  MapSlice slice(std::span<const double> live) const;
  /// The quantity, projected over the Projected variables; the result is NaN (never visited) only if all values are.
  ValueMap::Quantity projected(const Task& task, ValueMap::Quantity quantity) const;
};

/// The number of values on the map of the greedy action, and the name of one of them.
std::size_t greedyValues(const MapChoice& choice, const Task& task);
QString greedyNameOf(const MapChoice& choice, const Task& task, std::size_t value);
/// "best action", "torque 1.50", …
QString quantityText(const MapChoice& choice, const Task& task);
/// "α × α̇"
QString axesText(const MapChoice& choice, const Task& task);
/// "β̇ live −1.8", "β̇ mean"; several: "3 others".
QString othersText(const MapChoice& choice, const Task& task, std::span<const double> live);

}  // namespace surefoot
