// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "app/library/description.h"
#include "app/library/own_parts.h"
#include "core/basics/typed_json.h"

namespace surefoot {

using Json = nlohmann::json;

namespace {

constexpr int kMostTiles = 1000;

Result<double> finite(const Json& json, const std::string& of, const char* key, std::optional<double> otherwise) {
  if ((!json.contains(key) || json[key].is_null()) && otherwise) return *otherwise;
  if (json.contains(key) && json[key].is_number() && std::isfinite(json[key].get<double>()))
    return json[key].get<double>();
  return Error{fmt::format("task: {} needs a finite number \"{}\".", of, key)};
}

Result<StateVariable> variableOf(const Json& json, std::size_t index) {
  const std::string of = fmt::format("state variable {}", index);
  if (!json.is_object() || textIn(json, "key", "").empty())
    return Error{fmt::format("task: {} is no object with a \"key\".", of)};
  StateVariable v{.key = textIn(json, "key", "")};
  v.title = textIn(json, "title", v.key.c_str());
  v.symbol = textIn(json, "symbol", v.key.c_str());
  v.unit = textIn(json, "unit", "");
  const auto low = finite(json, of, "low", {}), high = finite(json, of, "high", {});
  if (!low) return low.error();
  if (!high) return high.error();
  if (!(*low < *high))
    return Error{fmt::format("task: {} goes from {} to {}; low must be below high.", of, *low, *high)};
  v.low = v.viewLow = *low, v.high = v.viewHigh = *high, v.span = *high - *low;
  v.spanText = "range", v.perSpan = "/range";
  v.whole = json.contains("whole") && json["whole"].is_boolean() && json["whole"].get<bool>();
  const auto resolution = finite(json, of, "resolution", v.whole ? v.span + 1 : 10.0);
  if (!resolution) return resolution.error();
  if (!(*resolution > 0 && *resolution <= kMostTiles))
    return Error{
        fmt::format("task: {} has the resolution {}; it goes from above 0 to {} tiles.", of, *resolution, kMostTiles)};
  v.resolution = *resolution;
  if (json.contains("period") && !json["period"].is_null()) {
    const auto period = finite(json, of, "period", {});
    if (!period) return period.error();
    if (!(*period > 0)) return Error{fmt::format("task: {} has the period {}; it must be above 0.", of, *period)};
    v.period = *period;
  }
  return v;
}

Status readState(const Json& json, Task& task) {
  const Json& list = partOf(json, "state");
  if (!list.is_array() || list.empty() || list.size() > kMaxStateVariables)
    return Error{fmt::format("task: \"state\" is a list of 1 to {} variables.", kMaxStateVariables)};
  std::set<std::string> keys;
  for (const Json& entry : list) {
    auto variable = variableOf(entry, task.state.size());
    if (!variable) return variable.error();
    if (!keys.insert(variable->key).second)
      return Error{fmt::format("task: two state variables are called \"{}\".", variable->key)};
    task.state.push_back(std::move(*variable));
  }
  return Done{};
}

Status readActions(const Json& json, Task& task) {
  const Json& list = partOf(json, "actions");
  if (!list.is_array() || list.empty() || list.size() > kMaxActions)
    return Error{fmt::format("task: \"actions\" is a list of 1 to {} numbers, or of names.", kMaxActions)};
  const bool named = list[0].is_string();
  for (const Json& entry : list) {
    if (named != entry.is_string() || (!named && !(entry.is_number() && std::isfinite(entry.get<double>()))))
      return Error{"task: \"actions\" are all finite numbers, or all names."};
    task.actions.push_back(named ? static_cast<double>(task.actions.size()) : entry.get<double>());
    if (named) task.actionNames.push_back(entry.get<std::string>());
  }
  task.actionTitle = textIn(json, "action_title", "action");
  task.actionSymbol = "a";
  task.actionUnit = textIn(json, "action_unit", "");
  return Done{};
}

Status readRewards(const Json& json, Task& task) {
  if (!json.contains("reward_terms")) {
    task.rewardTerms = {"reward"};
  } else {
    const Json& list = partOf(json, "reward_terms");
    if (!list.is_array() || list.empty() || list.size() > kMaxTaskTerms)
      return Error{fmt::format("task: \"reward_terms\" is a list of 1 to {} names.", kMaxTaskTerms)};
    for (const Json& entry : list) {
      if (!entry.is_string()) return Error{"task: \"reward_terms\" are names."};
      task.rewardTerms.push_back(entry.get<std::string>());
    }
  }
  for (const auto& [key, place] : {std::pair{"goal_reward", &task.goalReward}, std::pair{"step_time", &task.stepTime}})
    if (json.contains(key) && !json[key].is_null()) {
      const auto value = finite(json, "it", key, {});
      if (!value) return value.error();
      *place = *value;
    }
  if (task.stepTime && !(*task.stepTime > 0))
    return Error{fmt::format("task: \"step_time\" is {}; it must be above 0 s.", *task.stepTime)};
  const auto time = finite(json, "it", "time_reward", 0.0);
  if (!time) return time.error();
  task.timeReward = *time;
  return Done{};
}

}  // namespace

Result<Task> ownTask(const char* text) {
  if (!text) return Error{"task: it is NULL."};
  const auto json = parseDescription(text, "task",
                                     {"state", "actions", "title", "action_title", "action_unit", "reward_terms",
                                      "step_time", "goal_reward", "time_reward", "can_fall"});
  if (!json) return json.error();
  Task task;
  for (const auto read : {readState, readActions, readRewards})
    if (const Status s = read(*json, task); !s) return s.error();
  task.canFall = !json->contains("can_fall") || (*json)["can_fall"] != Json(false);
  return task;
}

}  // namespace surefoot
