// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "physics/robot/task/robot_values.h"

namespace surefoot {

namespace {

StateVariable variableOf(const StateSpec& spec, std::span<const double> values) {
  StateVariable v = spec.words;
  v.low = spec.range[0](values), v.high = spec.range[1](values);
  v.span = spec.span ? (*spec.span)(values) : 1.0;
  if (spec.width)
    v.resolution = v.span / (*spec.width)(values);
  else if (spec.resolution)
    v.resolution = (*spec.resolution)(values);
  else
    v.resolution = 8.0 * v.span / (v.high - v.low);
  if (spec.wrap) v.period = v.high - v.low;
  v.viewLow = spec.view ? (*spec.view)[0](values) : v.low;
  v.viewHigh = spec.view ? (*spec.view)[1](values) : v.high;
  return v;
}

ActionVariable variableOf(const ActuatorSpec& spec, std::span<const double> values) {
  ActionVariable v{.key = spec.name, .title = spec.title, .symbol = spec.symbol, .unit = spec.unit};
  for (const Formula& level : spec.levels) v.levels.push_back(level(values));
  if (v.symbol.empty()) v.symbol = spec.title;
  if (spec.width) {
    v.resolution = 1.0 / (*spec.width)(values);
  } else if (v.levels.size() > 1) {
    const auto [low, high] = std::minmax_element(v.levels.begin(), v.levels.end());
    v.resolution = *high > *low ? static_cast<double>(v.levels.size() - 1) / (*high - *low) : 1.0;
  }
  return v;
}

void addActions(const RobotSpec& spec, std::span<const double> values, Task& task) {
  std::vector<ActionVariable> variables;
  std::size_t actions = 1;
  for (const ActuatorSpec& actuator : spec.actuators) {
    if (actuator.levels.empty()) continue;
    variables.push_back(variableOf(actuator, values));
    actions *= actuator.levels.size();
  }
  task.actionTitle = variables.front().title;
  task.actionSymbol = variables.front().symbol;
  task.actionUnit = variables.front().unit;
  if (variables.size() == 1) {
    task.actions = variables.front().levels;
    return;
  }
  const bool alike = std::all_of(variables.begin(), variables.end(),
                                 [&](const ActionVariable& v) { return v.unit == variables.front().unit; });
  task.actionTitle = "action";
  task.actionSymbol = "u";
  if (!alike) task.actionUnit.clear();
  for (std::size_t a = 0; a < actions; ++a) task.actions.push_back(static_cast<double>(a));
  task.actionVariables = std::move(variables);
}

void addRewards(const RobotSpec& spec, std::span<const double> values, Task& task) {
  const int moving = spec.names.placeOf(NameKind::Memory, 0);
  for (const RewardSpec& reward : spec.rewards) {
    task.rewardTerms.push_back(reward.name);
    const auto uses = reward.value.expression.variables();
    const bool fixed = std::all_of(uses.begin(), uses.end(), [&](int place) { return place < moving; });
    if (reward.potential || !fixed) continue;
    if (!reward.when && !reward.ending) task.timeReward += reward.value(values);
    if (reward.ending && spec.endings[static_cast<std::size_t>(*reward.ending)].kind == EndingSpec::Kind::Goal)
      task.goalReward = task.goalReward.value_or(0.0) + reward.value(values);
  }
}

bool hasFalls(const RobotSpec& spec) {
  const auto falls = [](const EndingSpec& e) { return e.kind == EndingSpec::Kind::Fall; };
  return std::any_of(spec.endings.begin(), spec.endings.end(), falls) ||
         std::any_of(spec.events.begin(), spec.events.end(), falls);
}

}  // namespace

Task robotTask(const RobotSpec& spec, std::span<const double> values) {
  Task task;
  for (const StateSpec& state : spec.states) task.state.push_back(variableOf(state, values));
  addActions(spec, values, task);
  addRewards(spec, values, task);
  for (const MeasureSpec& measure : spec.measures) task.measures.push_back(measure.words);
  task.testEvery = static_cast<int>(std::clamp(spec.testEvery(values), 0.0, 1e6));
  task.stepTime = spec.stepTime(values);
  task.handMade = spec.hasHandMade();
  task.canFall = hasFalls(spec);
  task.lowestReturn = spec.returns[0](values);
  task.highestReturn = spec.returns[1](values);
  return task;
}

}  // namespace surefoot
