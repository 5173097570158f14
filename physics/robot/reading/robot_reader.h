// SPDX-License-Identifier: GPL-3.0-or-later
// What the sections of a robot's file are read with: numbers, pairs and lists of them, names of other things.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "physics/robot/reading/words.h"
#include "physics/robot/spec/robot_spec.h"

namespace surefoot {

class RobotReader {
 public:
  using Where = RobotWords::Where;

  RobotReader(RobotSpec& spec, std::vector<Complaint>& complaints) : spec_(spec), complaints_(complaints) {}

  RobotSpec& spec() { return spec_; }
  std::vector<Complaint>& complaints() { return complaints_; }
  /// From here on constants before this one may be used.
  void setConstants(int known) { constants_ = known; }

  /// A number or an expression; a complaint: it is neither.
  std::optional<Formula> formula(const TomlNode& node, std::string_view key, Where where,
                                 ValueKind wanted = ValueKind::Number, int actuator = -1);

  /// The value of a key; none: it is not there, or wrong.
  std::optional<Formula> maybe(TomlReader& reader, std::string_view key, Where where = Where::Fixed,
                               ValueKind wanted = ValueKind::Number, int actuator = -1);
  Formula number(TomlReader& reader, std::string_view key, double otherwise);
  Formula needed(TomlReader& reader, std::string_view key, Where where = Where::Fixed,
                 ValueKind wanted = ValueKind::Number);
  std::optional<FormulaPair> maybePair(TomlReader& reader, std::string_view key, Where where = Where::Fixed);
  FormulaPair pair(TomlReader& reader, std::string_view key, double x, double y);
  std::vector<Formula> numbers(TomlReader& reader, std::string_view key);
  std::vector<FormulaPair> pairs(TomlReader& reader, std::string_view key);

  /// The index of a thing that a key names; `otherwise` if the key is missing or wrong.
  int indexOf(TomlReader& reader, std::string_view key, NameKind kind, int otherwise = -1);
  std::optional<int> indexOf(const TomlNode& node, NameKind kind);

  /// One of some words; the first is the usual one.
  template <class Enum, std::size_t N>
  Enum choice(TomlReader& reader, std::string_view key, const std::pair<const char*, Enum> (&words)[N],
              Enum otherwise) {
    const std::string text = reader.text(key);
    std::string all;
    for (const auto& [word, value] : words) {
      if (text == word) return value;
      all += fmt::format("{}{}", all.empty() ? "" : ", ", word);
    }
    if (reader.find(key) && !text.empty()) reader.complain(key, fmt::format("\"{}\" is not one of {}.", text, all));
    return otherwise;
  }

 private:
  std::optional<FormulaPair> pairOf(const TomlNode& node, std::string_view key, Where where = Where::Fixed);

  RobotSpec& spec_;
  std::vector<Complaint>& complaints_;
  int constants_ = 0;
};

/// "body", "point", …: what such a thing is called.
const char* wordFor(NameKind kind);

}  // namespace surefoot
