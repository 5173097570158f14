// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/library/description.h"
#include "core/experiment/configuration_json.h"
#include "core/saved/stored_function.h"

namespace surefoot {

namespace {

OrderedJson about(const StateVariable& v) {
  OrderedJson json = {{"key", v.key}, {"title", v.title}, {"symbol", v.symbol}, {"unit", v.unit},
                      {"low", v.low}, {"high", v.high},   {"period", nullptr},  {"whole", v.whole}};
  if (v.period) json["period"] = *v.period;
  json["resolution"] = v.resolution;
  json["span"] = v.span;
  return json;
}

OrderedJson about(const Signal& s) {
  return {{"key", s.key},   {"title", s.title}, {"symbol", s.symbol},
          {"unit", s.unit}, {"group", s.group}, {"kind", s.kind == Signal::Kind::OnOff ? "on_off" : "number"}};
}

/// One for each action: its physical values.
OrderedJson coordinates(const Task& task) {
  OrderedJson list = OrderedJson::array();
  for (std::size_t a = 0; a < task.actions.size(); ++a) list.push_back(actionValues(task, a));
  return list;
}

OrderedJson variables(const Task& task) {
  OrderedJson list = OrderedJson::array();
  for (const ActionVariable& v : task.actionVariables)
    list.push_back({{"key", v.key}, {"title", v.title}, {"unit", v.unit}, {"levels", v.levels}});
  if (list.empty())
    list.push_back(
        {{"key", "action"}, {"title", task.actionTitle}, {"unit", task.actionUnit}, {"levels", task.actions}});
  return list;
}

/// Its own parameters alone.
OrderedJson parametersOf(const Configuration& c) {
  OrderedJson all = parametersAsJson(c.parameters), own = OrderedJson::object();
  for (const auto& [key, value] : all.items())
    if (key.starts_with("environment.")) own[key] = value;
  return own;
}

template <class List>
OrderedJson listOf(const List& list) {
  OrderedJson json = OrderedJson::array();
  for (const auto& entry : list) json.push_back(about(entry));
  return json;
}

}  // namespace

OrderedJson aboutWorld(const Environment& environment, const Configuration& c) {
  const Task& task = environment.task();
  OrderedJson json = {{"environment", c.names.environment},
                      {"preset", c.names.preset},
                      {"scenario", c.names.scenario},
                      {"parameters", parametersOf(c)},
                      {"state", listOf(task.state)},
                      {"actions", coordinates(task)},
                      {"action_names", task.actionNames},
                      {"action_variables", variables(task)},
                      {"reward_terms", task.rewardTerms},
                      {"measures", OrderedJson::array()},
                      {"signals", listOf(environment.signals())},
                      {"step_time", nullptr},
                      {"goal_reward", nullptr},
                      {"can_fall", task.canFall},
                      {"hand_made", task.handMade}};
  for (const TaskMeasure& m : task.measures)
    json["measures"].push_back({{"key", m.key}, {"title", m.title}, {"unit", m.unit}});
  if (task.stepTime) json["step_time"] = *task.stepTime;
  if (task.goalReward) json["goal_reward"] = *task.goalReward;
  return json;
}

}  // namespace surefoot
