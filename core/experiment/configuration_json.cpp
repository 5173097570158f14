// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/configuration_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/environment_library.h"
#include "core/text/text.h"

namespace surefoot {

using nlohmann::ordered_json;

namespace {

template <class T>
ordered_json orNull(const std::optional<T>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

/// A number that may be missing or null.
template <class T>
bool readOptional(const Json& json, const char* key, std::optional<T>& value, T low, T high) {
  if (!json.contains(key) || json[key].is_null()) return true;
  const bool right = std::is_integral_v<T> ? json[key].is_number_integer() : json[key].is_number();
  if (!right) return false;
  const T number = json[key].get<T>();
  if (!(number >= low && number <= high)) return false;
  value = number;
  return true;
}

/// The text of a robot that travels in the file: it becomes an environment here.
Status readEnvironmentText(const Registry& registry, const Json& json, const std::string& file, std::string& name,
                           std::string& otherProgram) {
  if (isEnvironmentPath(name)) return fileError(file, "its environment is a path, which no file of ours holds.");
  if (!json.contains("environment_text")) return Done{};
  if (!json["environment_text"].is_string() || !registry.files)
    return fileError(file, "the text of its environment is none.");
  const bool place = json.contains("environment_path") && json["environment_path"].is_string();
  const auto made = registry.files->add(json["environment_text"].get_ref<const std::string&>(), file,
                                        place ? json["environment_path"].get<std::string>() : "");
  if (!made) return made.error();
  const std::string before = std::exchange(name, (*made)->entry.name);
  if (!(*made)->starts.empty() && name != before) otherProgram = before;
  return Done{};
}

/// Parameters that came later are written only where they are not as usual: files that do not use them stay as they
/// were, and so do the contents of stores.
bool isLeftOut(const Parameters::Entry& entry) {
  constexpr std::string_view kLater[] = {"risk.",        "policy.risk",  "policy.losses",      "policy.guardian",
                                         "policy.omega", "agent.budget", "agent.falls_budget", "split.price_of_fall",
                                         "life."};
  const bool later = std::any_of(std::begin(kLater), std::end(kLater),
                                 [&](std::string_view prefix) { return entry.parameter.key.starts_with(prefix); });
  return (later || entry.parameter.key.ends_with(".asymmetry")) && entry.value == entry.usual;
}

}  // namespace

ordered_json parametersAsJson(const Parameters& list) {
  ordered_json parameters = ordered_json::object();
  for (const auto& entry : list.all()) {
    if (isLeftOut(entry)) continue;
    const Parameter& p = entry.parameter;
    if (p.kind == Kind::Choice)
      parameters[p.key] = formatValue(p, entry.value);
    else if (p.kind == Kind::Integer)
      parameters[p.key] = static_cast<std::int64_t>(entry.value);
    else
      parameters[p.key] = entry.value;
  }
  return parameters;
}

ordered_json configurationAsJson(const Configuration& c) {
  ordered_json json = {{"environment", c.names.environment},
                       {"preset", c.names.preset},
                       {"scenario", c.names.scenario},
                       {"agent", c.names.agent},
                       {"features", c.names.features},
                       {"policy", c.names.policy},
                       {"parameters", parametersAsJson(c.parameters)},
                       {"lives", c.lives},
                       {"minutes", orNull(c.minutes)},
                       {"episodes", orNull(c.episodes)},
                       {"until", orNull(c.until)}};
  if (c.environmentFile) json["environment_text"] = c.environmentFile->text;
  if (isMovedByProgram(c)) json["environment_path"] = c.environmentFile->home;
  return json;
}

Status setParameters(Parameters& parameters, const Json& json, const std::string& file) {
  if (!json.is_object()) return fileError(file, "its parameters are not a list of names and values.");
  for (const auto& [key, value] : json.items()) {
    Status set = Error{fmt::format("the parameter \"{}\" is neither a number nor a name.", shortened(key))};
    if (value.is_number()) set = parameters.set(key, value.get<double>());
    if (value.is_string()) set = parameters.set(key, std::string_view(value.get_ref<const std::string&>()));
    if (!set) return Error{fmt::format("{}: {}", file, set.error().message), ErrorKind::File};
  }
  return Done{};
}

Result<Configuration> configurationFromJson(const Registry& registry, const Json& json, const std::string& file) {
  if (!json.is_object()) return fileError(file, "it holds no configuration.");
  Names names;
  for (const auto& [key, name] : {std::pair{"environment", &names.environment}, std::pair{"preset", &names.preset},
                                  std::pair{"scenario", &names.scenario}, std::pair{"agent", &names.agent},
                                  std::pair{"features", &names.features}, std::pair{"policy", &names.policy}}) {
    if (!json.contains(key) || !json[key].is_string())
      return fileError(file, fmt::format("its configuration names no {}.", key));
    *name = json[key].get<std::string>();
  }
  std::string otherProgram;
  if (const Status s = readEnvironmentText(registry, json, file, names.environment, otherProgram); !s) return s.error();
  auto c = configure(registry, names, {});
  if (!c) return Error{fmt::format("{}: {}", file, c.error().message), ErrorKind::File};
  c->otherProgram = otherProgram;
  if (json.contains("parameters"))
    if (const Status s = setParameters(c->parameters, json["parameters"], file); !s) return s.error();
  if (!readOptional(json, "minutes", c->minutes, 0.0, 1e9) ||
      !readOptional<std::int64_t>(json, "episodes", c->episodes, 1, 1'000'000'000'000) ||
      !readOptional(json, "until", c->until, -1e12, 1e12))
    return fileError(file, "its configuration has a limit that is no such number.");
  return c;
}

}  // namespace surefoot
