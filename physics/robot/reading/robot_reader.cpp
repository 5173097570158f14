// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/reading/robot_reader.h"

#include <algorithm>
#include <cmath>

#include "core/expression/compile.h"
#include "core/text/printable.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

using Node = TomlNode::Kind;

namespace {

/// The characters before a byte of a text: columns of a file count characters.
int charactersBefore(std::string_view text, std::size_t byte) {
  return static_cast<int>(std::count_if(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(byte),
                                        [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

}  // namespace

const char* wordFor(NameKind kind) {
  switch (kind) {
    case NameKind::Parameter:
      return "parameter";
    case NameKind::Constant:
      return "constant";
    case NameKind::Body:
      return "body";
    case NameKind::Point:
      return "point";
    case NameKind::Joint:
      return "joint";
    case NameKind::Actuator:
      return "actuator";
    case NameKind::Ray:
      return "ray";
    case NameKind::Memory:
      return "memory";
    case NameKind::State:
      return "state";
    case NameKind::Child:
      return "child";
  }
  return "thing";
}

std::optional<Formula> RobotReader::formula(const TomlNode& node, std::string_view key, Where where, ValueKind wanted,
                                            int actuator) {
  if (node.kind == Node::Whole || node.kind == Node::Number) {
    if (std::isfinite(node.number)) return formulaOf(node.number, node.at);
    complaints_.push_back({node.at, fmt::format("{}: {} is no finite number.", key, node.number)});
    return std::nullopt;
  }
  if (node.kind == Node::Flag) return formulaOf(node.flag ? 1.0 : 0.0, node.at);
  if (node.kind != Node::Text) {
    complaints_.push_back({node.at, fmt::format("{}: it takes a number, or an expression in quotes.", key)});
    return std::nullopt;
  }
  std::size_t at = 0;
  auto compiled = compile(node.text, wanted, RobotWords(spec_.names, where, constants_, actuator), at);
  if (compiled) return Formula{std::move(*compiled), node.at};
  TextPlace place = node.at;
  place.column += 1 + charactersBefore(node.text, std::min(at, node.text.size()));
  complaints_.push_back({place, fmt::format("{}: {}", key, compiled.error().message)});
  return std::nullopt;
}

std::optional<Formula> RobotReader::maybe(TomlReader& reader, std::string_view key, Where where, ValueKind wanted,
                                          int actuator) {
  const TomlNode* node = reader.find(key);
  return node ? formula(*node, key, where, wanted, actuator) : std::nullopt;
}

Formula RobotReader::number(TomlReader& reader, std::string_view key, double otherwise) {
  return maybe(reader, key).value_or(formulaOf(otherwise));
}

Formula RobotReader::needed(TomlReader& reader, std::string_view key, Where where, ValueKind wanted) {
  return reader.need(key) ? maybe(reader, key, where, wanted).value_or(Formula{}) : Formula{};
}

std::optional<FormulaPair> RobotReader::pairOf(const TomlNode& node, std::string_view key, Where where) {
  if (node.kind != Node::List || node.list.size() != 2) {
    complaints_.push_back({node.at, fmt::format("{}: it takes two numbers, such as [0, 0.5].", key)});
    return std::nullopt;
  }
  const auto a = formula(node.list[0], key, where), b = formula(node.list[1], key, where);
  if (!a || !b) return std::nullopt;
  return FormulaPair{*a, *b};
}

std::optional<FormulaPair> RobotReader::maybePair(TomlReader& reader, std::string_view key, Where where) {
  const TomlNode* node = reader.find(key);
  return node ? pairOf(*node, key, where) : std::nullopt;
}

FormulaPair RobotReader::pair(TomlReader& reader, std::string_view key, double x, double y) {
  return maybePair(reader, key).value_or(FormulaPair{formulaOf(x), formulaOf(y)});
}

std::vector<Formula> RobotReader::numbers(TomlReader& reader, std::string_view key) {
  std::vector<Formula> all;
  const TomlNode* node = reader.find(key);
  if (node && node->kind != Node::List) reader.complain(key, "it takes a list of numbers.");
  for (const TomlNode& element : node ? node->list : std::vector<TomlNode>{})
    if (auto one = formula(element, key, Where::Fixed)) all.push_back(std::move(*one));
  return all;
}

std::vector<FormulaPair> RobotReader::pairs(TomlReader& reader, std::string_view key) {
  std::vector<FormulaPair> all;
  const TomlNode* node = reader.find(key);
  if (node && node->kind != Node::List) reader.complain(key, "it takes a list of points, such as [[0, 0], [1, 0]].");
  for (const TomlNode& element : node ? node->list : std::vector<TomlNode>{})
    if (auto one = pairOf(element, key)) all.push_back(std::move(*one));
  return all;
}

std::optional<int> RobotReader::indexOf(const TomlNode& node, NameKind kind) {
  if (node.kind != Node::Text) {
    complaints_.push_back({node.at, fmt::format("it takes the name of a {}.", wordFor(kind))});
    return std::nullopt;
  }
  const RobotNames::Name* found = spec_.names.find(node.text);
  if (found && found->kind == kind) return found->index;
  const std::string near = nearestWord(node.text, spec_.names.all(kind));
  complaints_.push_back(
      {node.at, fmt::format("there is no {} \"{}\"{}.", wordFor(kind), printable(shortened(node.text)),
                            near.empty() ? "" : fmt::format(" (did you mean {}?)", near))});
  return std::nullopt;
}

int RobotReader::indexOf(TomlReader& reader, std::string_view key, NameKind kind, int otherwise) {
  const TomlNode* node = reader.find(key);
  return node ? indexOf(*node, kind).value_or(otherwise) : otherwise;
}

}  // namespace surefoot
