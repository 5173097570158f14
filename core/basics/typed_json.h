// SPDX-License-Identifier: GPL-3.0-or-later
// Values in JSON from outside, if they have the expected type. These functions never throw: a value of another type
// counts as missing.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace surefoot {

inline std::string textIn(const nlohmann::json& json, const char* key, const char* otherwise = "") {
  const bool there = json.is_object() && json.contains(key) && json[key].is_string();
  return there ? json[key].get<std::string>() : otherwise;
}

inline double numberIn(const nlohmann::json& json, const std::string& key,
                       double otherwise = std::numeric_limits<double>::quiet_NaN()) {
  return json.is_object() && json.contains(key) && json[key].is_number() ? json[key].get<double>() : otherwise;
}

/// JSON as text. Whatever it holds this never throws: bytes that are no UTF-8, as old disks have them in names of
/// files, become U+FFFD. `indent` < 0: in one line; `ascii`: other letters as \u escapes.
template <class AnyJson>
std::string jsonText(const AnyJson& json, int indent = -1, bool ascii = false) {
  return json.dump(indent, ' ', ascii, AnyJson::error_handler_t::replace);
}

/// An object or a list; an empty one if there is none.
inline const nlohmann::json& partOf(const nlohmann::json& json, const char* key) {
  static const nlohmann::json kNone = nlohmann::json::object();
  return json.is_object() && json.contains(key) && json[key].is_structured() ? json[key] : kNone;
}

}  // namespace surefoot
