// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/task_description.h"

#include <fmt/format.h>

#include "core/basics/typed_json.h"
#include "core/files/read_file.h"
#include "core/text/text.h"

namespace surefoot {

Json stateAsJson(const Task& task) {
  Json list = Json::array();
  for (const StateVariable& v : task.state)
    list.push_back({{"variable", v.key},
                    {"title", v.title},
                    {"unit", v.unit},
                    {"low", v.low},
                    {"high", v.high},
                    {"period", v.period ? Json(*v.period) : Json(nullptr)}});
  return list;
}

Json actionsAsJson(const Task& task) {
  Json json = {
      {"title", task.actionTitle}, {"unit", task.actionUnit}, {"values", task.actions}, {"names", task.actionNames}};
  for (const ActionVariable& v : task.actionVariables)  // the values then only number the combinations
    json["variables"].push_back({{"variable", v.key}, {"title", v.title}, {"unit", v.unit}, {"levels", v.levels}});
  return json;
}

namespace {

/// What a named thing of the file has otherwise than that of the configuration: "the unit of pole_rate is …".
std::optional<std::string> otherwise(const Json& theirs, const Json& ours, const char* key, const char* what) {
  if (!theirs.is_object() || !theirs.contains(key)) return std::nullopt;  // an older file does not say it
  const Json mine = ours.contains(key) ? ours[key] : Json(nullptr);
  if (theirs[key] == mine) return std::nullopt;
  return fmt::format("it was learned by another robot: {} of {} is {} in the file, and {} in the configuration.", what,
                     ours.value("variable", "?"), shortened(jsonText(theirs[key], -1, true)),
                     shortened(jsonText(mine, -1, true)));
}

/// The first difference between two lists of named things that have the same names.
std::optional<std::string> firstDifference(const Json& theirs, const Json& ours,
                                           std::initializer_list<std::pair<const char*, const char*>> keys) {
  for (std::size_t i = 0; i < ours.size(); ++i)
    for (const auto& [key, what] : keys)
      if (auto difference = otherwise(theirs[i], ours[i], key, what)) return difference;
  return std::nullopt;
}

}  // namespace

Status checkTask(const TensorFile& file, const Task& task) {
  const auto refuse = [&](const std::string& what, const Json& theirs, const Json& ours) {
    return fileError(file.name,
                     fmt::format("{} is {} in the file, and {} in the configuration.", what,
                                 shortened(jsonText(theirs, -1, true)), shortened(jsonText(ours, -1, true))));
  };
  const Json& about = file.about;
  const Json state = stateAsJson(task), actions = actionsAsJson(task);
  if (!about.contains("state") || !about["state"].is_array() || !about.contains("actions") ||
      !about["actions"].is_object())
    return fileError(file.name, "its description names no state or no actions; the file is damaged.");
  const auto names = [](const Json& list) {
    Json keys = Json::array();
    for (const Json& v : list) keys.push_back(v.is_object() && v.contains("variable") ? v["variable"] : Json(nullptr));
    return keys;
  };
  if (names(about["state"]) != names(state)) return refuse("the state", names(about["state"]), names(state));
  if (const auto d = firstDifference(about["state"], state, {{"unit", "the unit"}, {"period", "the period"}}))
    return fileError(file.name, *d);
  if (const Json& theirs = about["actions"]; theirs.contains("variables") && theirs["variables"].is_array()) {
    const Json ours = actions.contains("variables") ? actions["variables"] : Json::array();
    if (names(theirs["variables"]) != names(ours))
      return refuse("the list of actuators", names(theirs["variables"]), names(ours));
    if (const auto d = firstDifference(theirs["variables"], ours, {{"unit", "the unit"}, {"levels", "the levels"}}))
      return fileError(file.name, *d);
  }
  for (const char* key : {"values", "names"}) {
    const Json theirs = about["actions"].contains(key) ? about["actions"][key] : Json(nullptr);
    if (theirs.is_array() && theirs.size() != actions[key].size())
      return refuse("the number of actions", theirs.size(), actions[key].size());
    if (theirs != actions[key]) return refuse(fmt::format("the list of action {}", key), theirs, actions[key]);
  }
  return Done{};
}

}  // namespace surefoot
