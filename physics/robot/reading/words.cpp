// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/reading/words.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text/printable.h"
#include "core/text/text.h"
#include "core/text/words.h"
#include "physics/robot/spec/bodies.h"

namespace surefoot {

namespace {

using What = Probe::What;

struct Attribute {
  std::string_view name;
  What what;
};

std::vector<Attribute> attributes(NameKind kind) {
  switch (kind) {
    case NameKind::Body:
      return {{"x", What::X},   {"y", What::Y},       {"angle", What::Angle},   {"vx", What::Vx},
              {"vy", What::Vy}, {"rate", What::Rate}, {"height", What::Height}, {"touches", What::Touches}};
    case NameKind::Point:
      return {{"x", What::X}, {"y", What::Y}, {"vx", What::Vx}, {"vy", What::Vy}, {"height", What::Height}};
    case NameKind::Joint:
      return {{"angle", What::Angle}, {"position", What::Angle}, {"length", What::Distance}, {"rate", What::Rate}};
    case NameKind::Actuator:
      return {{"u", What::U}, {"effort", What::Effort}, {"power", What::Power}};
    case NameKind::Ray:
      return {{"distance", What::Distance}};
    default:
      return {};
  }
}

std::optional<What> attributeNamed(NameKind kind, std::string_view name) {
  for (const Attribute& a : attributes(kind))
    if (a.name == name) return a.what;
  return std::nullopt;
}

ValueKind kindOf(What what) {
  return what == What::Touches ? ValueKind::Flag : ValueKind::Number;
}

Error noAttribute(std::string_view name, std::string_view part, const std::vector<std::string>& has) {
  const std::string near = nearestWord(part, has);
  return Error{fmt::format("\"{}\" has no \"{}\"; it has {}{}.", printable(shortened(name)), printable(shortened(part)),
                           joinWords(has), near.empty() ? "" : fmt::format(" (did you mean {}?)", near))};
}

}  // namespace

std::vector<std::string> attributesOf(NameKind kind) {
  std::vector<std::string> names;
  for (const Attribute& a : attributes(kind)) names.emplace_back(a.name);
  return names;
}

Quantity RobotWords::placed(const Probe& probe) const {
  return {.place = names_.placeOfProbe(probe), .kind = kindOf(probe.what)};
}

Result<Quantity> RobotWords::plain(std::string_view name) const {
  const bool moving = where_ == Where::Moving;
  if (moving && actuator_ >= 0 && name == "u")
    return placed({.of = NameKind::Actuator, .index = actuator_, .shape = -1, .what = What::U});
  if (moving && name == "step") return Quantity{.place = names_.placeOfStep()};
  if (moving && name == "time") return Quantity{.place = names_.placeOfTime()};
  const RobotNames::Name* found = names_.find(name);
  if (!found) return Error{""};
  const auto here = [&](ValueKind kind = ValueKind::Number) {
    return Quantity{.place = names_.placeOf(found->kind, found->index), .kind = kind};
  };
  if (where_ == Where::Parameter) return Error{"a parameter's own numbers name nothing; constants may use parameters."};
  switch (found->kind) {
    case NameKind::Parameter:
      return here();
    case NameKind::Constant:
      if (found->index < constants_) return here();
      return Error{fmt::format("the constant {} stands further down; a constant uses those above it.", name)};
    case NameKind::Memory:
    case NameKind::State:
      if (moving) return here(ValueKind::Flag);
      return Error{
          fmt::format("\"{}\" changes while the robot moves; here only parameters and constants can stand.", name)};
    default:
      return noAttribute(name, "", attributesOf(found->kind));
  }
}

Result<Quantity> RobotWords::ofBody(const RobotNames::Name& body, std::string_view part) const {
  const auto dot = part.find('.');
  const std::string_view first = part.substr(0, dot);
  if (dot == std::string_view::npos) {
    if (const auto what = attributeNamed(NameKind::Body, first))
      return placed({.of = NameKind::Body, .index = body.index, .shape = -1, .what = *what});
  }
  const auto& shapes = names_.shapesOf(body.index);
  const auto shape = std::find(shapes.begin(), shapes.end(), first);
  auto has = attributesOf(NameKind::Body);
  for (const std::string& name : shapes)
    if (!name.empty()) has.push_back(name);
  if (first.empty() || shape == shapes.end()) return noAttribute(body.text, first, has);
  if (dot == std::string_view::npos || part.substr(dot + 1) != "touches")
    return noAttribute(fmt::format("{}.{}", body.text, first),
                       dot == std::string_view::npos ? std::string_view() : part.substr(dot + 1), {"touches"});
  return placed({.of = NameKind::Body,
                 .index = body.index,
                 .shape = static_cast<int>(shape - shapes.begin()),
                 .what = What::Touches});
}

Result<Quantity> RobotWords::ofChild(std::string_view part) const {
  const auto& sent = names_.sent();
  const auto number = std::find(sent.begin(), sent.end(), part);
  if (number == sent.end()) return noAttribute("child", part, sent);
  const auto index = static_cast<std::size_t>(number - sent.begin());
  const bool flag = index == ChildSpec::kTerminated || index == ChildSpec::kTruncated;
  return Quantity{.place = names_.placeOfProbe(
                      {.of = NameKind::Child, .index = static_cast<int>(index), .shape = -1, .what = What::Sent}),
                  .kind = flag ? ValueKind::Flag : ValueKind::Number};
}

Result<Quantity> RobotWords::partOf(std::string_view name, std::string_view part) const {
  if (names_.hasChild() && name == "child" && where_ == Where::Moving) return ofChild(part);
  const RobotNames::Name* found = names_.find(name);
  if (!found) {
    const std::string near = nearestWord(name, names_.all());
    return Error{fmt::format("there is no body, point, joint, shape or actuator \"{}\"{}.", printable(shortened(name)),
                             near.empty() ? "" : fmt::format(" (did you mean {}?)", near))};
  }
  if (where_ != Where::Moving)
    return Error{fmt::format("\"{}.{}\" changes while the robot moves; here only parameters and constants can stand.",
                             name, printable(shortened(part)))};
  if (found->kind == NameKind::Body) return ofBody(*found, part);
  const auto has = names_.hasChild() && found->kind == NameKind::Actuator ? std::vector<std::string>{"u"}
                   : names_.hasChild()                                    ? std::vector<std::string>()
                                                                          : attributesOf(found->kind);
  if (has.empty() && names_.hasChild())
    return Error{fmt::format("\"{}.{}\": a program moves this robot; what it sends is child.NAME.", name,
                             printable(shortened(part)))};
  if (names_.hasChild() && part != "u") return noAttribute(name, part, has);
  if (has.empty()) return Error{fmt::format("\"{}\" is a number; nothing can stand behind it.", name)};
  if (const auto what = attributeNamed(found->kind, part))
    return placed({.of = found->kind, .index = found->index, .shape = -1, .what = *what});
  return noAttribute(name, part, has);
}

Result<Quantity> RobotWords::find(std::string_view name, std::optional<std::string_view> argument) const {
  for (const std::string_view degrees : {"deg", "degree", "degrees", "deg2rad", "radians"})
    if (name == degrees && !names_.find(name)) return Error{"angles are in rad: 30 degrees are 30 * pi / 180."};
  if (argument) {
    static const std::vector<std::string> kFunctions = {"abs",    "min",   "max",  "sign",  "floor",
                                                        "round",  "sqrt",  "sin",  "cos",   "exp",
                                                        "square", "clamp", "wrap", "hypot", "uniform"};
    const std::string near = nearestWord(name, kFunctions);
    return Error{fmt::format("there is no function \"{}\"; there are {}{}.", printable(shortened(name)),
                             joinWords(kFunctions), near.empty() ? "" : fmt::format(" (did you mean {}?)", near))};
  }
  const auto dot = name.find('.');
  return dot == std::string_view::npos ? plain(name) : partOf(name.substr(0, dot), name.substr(dot + 1));
}

std::vector<std::string> RobotWords::names() const {
  auto all = names_.all(NameKind::Parameter);
  for (const std::string& name : names_.all(NameKind::Constant)) all.push_back(name);
  if (where_ != Where::Moving) return all;
  all = names_.all();
  all.insert(all.end(), {"step", "time"});
  return all;
}

}  // namespace surefoot
