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
  for (const char* key : {"values", "names"}) {
    const Json theirs = about["actions"].contains(key) ? about["actions"][key] : Json(nullptr);
    if (theirs.is_array() && theirs.size() != actions[key].size())
      return refuse("the number of actions", theirs.size(), actions[key].size());
    if (theirs != actions[key]) return refuse(fmt::format("the list of action {}", key), theirs, actions[key]);
  }
  return Done{};
}

}  // namespace surefoot
