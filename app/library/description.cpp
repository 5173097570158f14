// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/library/description.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/environment_library.h"
#include "core/environment_programs.h"
#include "core/files/limited_json.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

using Json = nlohmann::json;

namespace {

Error wrongType(const std::string& key, const Json& value, const char* needed) {
  return Error{fmt::format("{}: {} is not {}.", key,
                           shortened(value.dump(-1, ' ', false, Json::error_handler_t::replace)), needed)};
}

}  // namespace

Result<Json> parseDescription(const char* text, const char* name, const std::vector<std::string>& keys) {
  if (!text) return Json::object();
  Json json = parseJson(text);
  if (!json.is_object()) return Error{fmt::format("{}: it is no JSON object, such as {{\"{}\": …}}.", name, keys[0])};
  for (const auto& [key, value] : json.items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      const std::string near = nearestWord(key, keys);
      return Error{fmt::format("{}: it has no \"{}\"{}; it takes {}.", name, shortened(key),
                               near.empty() ? "" : ", did you mean " + near, joinWords(keys, "and"))};
    }
  return json;
}

Result<std::optional<std::string>> textOf(const Json& json, const std::string& key) {
  if (!json.contains(key) || json[key].is_null()) return std::optional<std::string>();
  if (!json[key].is_string()) return wrongType(key, json[key], "a text");
  return std::optional(json[key].get<std::string>());
}

Result<std::optional<std::string>> numberOf(const Json& json, const std::string& key) {
  if (!json.contains(key) || json[key].is_null()) return std::optional<std::string>();
  if (!json[key].is_number()) return wrongType(key, json[key], "a number");
  return std::optional(json[key].dump());
}

Result<bool> flagOf(const Json& json, const std::string& key) {
  if (!json.contains(key) || json[key].is_null()) return false;
  if (!json[key].is_boolean()) return wrongType(key, json[key], "true or false");
  return json[key].get<bool>();
}

Result<ChosenNames> namesIn(const Json& json) {
  ChosenNames names;
  for (const auto& [key, name] : {std::pair{"environment", &names.environment}, std::pair{"preset", &names.preset},
                                  std::pair{"scenario", &names.scenario}, std::pair{"agent", &names.agent},
                                  std::pair{"features", &names.features}, std::pair{"policy", &names.policy}}) {
    auto text = textOf(json, key);
    if (!text) return text.error();
    *name = std::move(*text);
  }
  return names;
}

Result<std::vector<std::string>> assignmentsIn(const Json& parameters) {
  std::vector<std::string> assignments;
  if (parameters.is_null()) return assignments;
  if (!parameters.is_object()) return wrongType("parameters", parameters, "an object of numbers and names");
  for (const auto& [key, value] : parameters.items()) {
    if (!value.is_number() && !value.is_string()) return wrongType(key, value, "a number or a name");
    const std::string text = value.is_string()         ? value.get<std::string>()
                             : value.is_number_float() ? fmt::format("{}", value.get<double>())
                                                       : value.dump();
    assignments.push_back(key + "=" + text);
  }
  return assignments;
}

void allowProgram(const Registry& registry, const Configuration& configuration) {
  if (isMovedByProgram(configuration)) registry.programs->allow(configuration.environmentFile->program);
}

Result<Configuration> worldIn(const Registry& registry, const char* description) {
  const auto json =
      parseDescription(description, "description", {"environment", "preset", "scenario", "parameters", "programs"});
  if (!json) return json.error();
  const auto names = namesIn(*json);
  if (!names) return names.error();
  const auto texts = assignmentsIn(json->value("parameters", Json()));
  if (!texts) return texts.error();
  const auto assignments = parseAssignments(*texts);
  if (!assignments) return assignments.error();
  for (const Assignment& a : *assignments)
    if (!a.key.starts_with("environment."))
      return Error{fmt::format("{}: a world has parameters that begin with \"environment.\" only.", shortened(a.key))};
  const auto programs = flagOf(*json, "programs");
  if (!programs) return programs.error();
  auto configuration = configure(registry, namesOr(*names, {}), *assignments);
  if (configuration && *programs) allowProgram(registry, *configuration);
  return configuration;
}

}  // namespace surefoot
