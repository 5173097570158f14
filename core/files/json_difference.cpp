// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/json_difference.h"

#include <fmt/format.h>

#include "core/basics/typed_json.h"
#include "core/text/text.h"

namespace surefoot {

using Json = nlohmann::json;

namespace {

/// The subject of an entry of a list, for example "pole_angle".
std::optional<std::string> subjectOf(const Json& entry) {
  if (entry.is_object() && entry.contains("variable") && entry["variable"].is_string())
    return entry["variable"].get<std::string>();
  return std::nullopt;
}

std::string shortText(const Json& json) {
  return std::string(shortened(jsonText(json, -1, true)));
}

}  // namespace

std::optional<Difference> firstDifference(const Json& theirs, const Json& ours, const std::string& where) {
  const auto inside = [&](const std::string& name) { return where.empty() ? name : name + " of " + where; };
  if (ours.is_object() && theirs.is_object()) {
    std::vector<std::string> keys;  // settings of a person first
    for (const char* key : {"kind", "tilings", "memory", "tile_width", "spacing", "width"})
      if (ours.contains(key)) keys.emplace_back(key);
    for (const auto& [key, value] : ours.items()) keys.push_back(key);
    for (const std::string& key : keys) {
      const Json& value = ours[key];
      if (!theirs.contains(key)) return Difference{inside(key), "nothing", shortText(value)};
      if (auto found = firstDifference(theirs[key], value, key == "variables" ? where : inside(key))) return found;
    }
    return std::nullopt;
  }
  if (ours.is_array() && theirs.is_array() && ours.size() == theirs.size()) {
    for (std::size_t i = 0; i < ours.size(); ++i)
      if (auto found =
              firstDifference(theirs[i], ours[i], subjectOf(ours[i]).value_or(inside(fmt::format("entry {}", i + 1)))))
        return found;
    return std::nullopt;
  }
  if (theirs == ours) return std::nullopt;
  return Difference{where, shortText(theirs), shortText(ours)};
}

}  // namespace surefoot
