// SPDX-License-Identifier: GPL-3.0-or-later
// What a value map shows: which quantity, over which two state variables, and what is done with the others.
#pragma once

#include <QString>
#include <span>
#include <vector>

#include "core/environment.h"
#include "ui/live/maps/value_map.h"

namespace surefoot {

enum class MapQuantity { BestAction, OneAction, GreedyAction, Visits, Eligibility };

/// A state variable that is no axis: it follows the live state, stands still, or is projected away.
enum class Across { Live, Fixed, Projected };
enum class Projection { Mean, Least, Most };

struct MapChoice {
  MapQuantity quantity = MapQuantity::BestAction;
  Action action = 0;  ///< of OneAction; of GreedyAction the action variable, where an action is a combination
  int x = 0, y = 1;
  std::vector<Across> across;  ///< one a state variable; those of the axes do not matter
  std::vector<double> fixed;   ///< their values, where they are fixed
  Projection projection = Projection::Mean;
  bool locked = true;  ///< the colours span what rewards allow; else what the map shows now

  /// Begins anew for a task.
  void fit(const Task& task);
  /// Whether the task has all that was chosen.
  bool suits(const Task& task) const;
  bool isAxis(std::size_t variable) const { return static_cast<int>(variable) == x || static_cast<int>(variable) == y; }
  /// The slice through a live state.
  MapSlice slice(std::span<const double> live) const;
  /// The quantity, projected over the variables that are; NaN (never visited) counts only if it is everywhere.
  ValueMap::Quantity projected(const Task& task, ValueMap::Quantity quantity) const;
};

/// "α", or the title where there is no symbol.
QString symbolOf(const StateVariable& variable);
/// "pole angle α [rad]"
QString axisTitleOf(const StateVariable& variable);
/// "1.50", or what the action is called.
QString actionNameOf(const Task& task, std::size_t action);
/// How many values the layer of the greedy action can have, and what one of them is called.
std::size_t greedyValues(const MapChoice& choice, const Task& task);
QString greedyNameOf(const MapChoice& choice, const Task& task, std::size_t value);
/// "best action", "torque 1.50", …
QString quantityText(const MapChoice& choice, const Task& task);
/// "α × α̇"
QString axesText(const MapChoice& choice, const Task& task);
/// "β̇ live −1.8", "β̇ mean"; several: "3 others".
QString othersText(const MapChoice& choice, const Task& task, std::span<const double> live);

}  // namespace surefoot
