// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace surefoot {

std::optional<std::size_t> measureAt(const std::vector<TaskMeasure>& measures, std::string_view key) {
  for (std::size_t m = 0; m < measures.size(); ++m)
    if (measures[m].key == key) return m;
  return std::nullopt;
}

std::size_t levelOf(const Task& task, std::size_t action, std::size_t variable) {
  for (std::size_t j = task.actionVariables.size(); j-- > variable + 1;)
    action /= task.actionVariables[j].levels.size();
  return action % task.actionVariables[variable].levels.size();
}

Action actionOf(const Task& task, std::span<const std::size_t> levels) {
  std::size_t action = 0;
  for (std::size_t j = 0; j < levels.size(); ++j) action = action * task.actionVariables[j].levels.size() + levels[j];
  return static_cast<Action>(action);
}

std::size_t nearestLevel(std::span<const double> levels, double value) {
  const auto nearest = std::min_element(levels.begin(), levels.end(),
                                        [&](double a, double b) { return std::abs(a - value) < std::abs(b - value); });
  return static_cast<std::size_t>(nearest - levels.begin());
}

std::vector<double> actionValues(const Task& task, std::size_t a) {
  if (task.actionVariables.empty()) return {task.actions[a]};
  std::vector<double> values;
  for (std::size_t j = 0; j < task.actionVariables.size(); ++j)
    values.push_back(task.actionVariables[j].levels[levelOf(task, a, j)]);
  return values;
}

Status checkState(const Task& task, std::span<const double> state) {
  if (state.size() != task.state.size())
    return Error{fmt::format("a state has {} values here, and {} are given.", task.state.size(), state.size())};
  for (std::size_t d = 0; d < state.size(); ++d) {
    const StateVariable& v = task.state[d];
    if (!(state[d] >= v.low && state[d] <= v.high))
      return Error{fmt::format("{} = {} is out of range; it goes from {} to {}.", v.key, state[d], v.low, v.high)};
  }
  return Done{};
}

}  // namespace surefoot
