// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/spec/names.h"

#include <algorithm>
#include <array>

#include "core/expression/functions.h"

namespace surefoot {

bool RobotNames::add(NameKind kind, const std::string& name) {
  if (find(name)) return false;
  names_.push_back({name, kind, count(kind)});
  return true;
}

const RobotNames::Name* RobotNames::find(std::string_view name) const {
  const auto found = std::find_if(names_.begin(), names_.end(), [&](const Name& n) { return n.text == name; });
  return found == names_.end() ? nullptr : &*found;
}

int RobotNames::count(NameKind kind) const {
  return static_cast<int>(std::count_if(names_.begin(), names_.end(), [&](const Name& n) { return n.kind == kind; }));
}

const std::string& RobotNames::nameOf(NameKind kind, int index) const {
  return std::find_if(names_.begin(), names_.end(), [&](const Name& n) { return n.kind == kind && n.index == index; })
      ->text;
}

std::vector<std::string> RobotNames::all() const {
  std::vector<std::string> texts;
  for (const Name& name : names_) texts.push_back(name.text);
  return texts;
}

std::vector<std::string> RobotNames::all(NameKind kind) const {
  std::vector<std::string> texts;
  for (const Name& name : names_)
    if (name.kind == kind) texts.push_back(name.text);
  return texts;
}

int RobotNames::placeOf(NameKind kind, int index) const {
  int place = 0;
  for (const NameKind before : {NameKind::Parameter, NameKind::Constant, NameKind::Memory, NameKind::State}) {
    if (before == kind) return place + index;
    place += count(before);
  }
  return -1;
}

int RobotNames::placeOfProbe(const Probe& probe) {
  const auto found = std::find(probes_.begin(), probes_.end(), probe);
  const auto index = static_cast<int>(found - probes_.begin());
  if (found == probes_.end()) probes_.push_back(probe);
  return firstProbe() + index;
}

const char* wrongName(std::string_view name) {
  constexpr std::size_t kLongest = 40;
  constexpr std::array<std::string_view, 8> kTaken = {"pi", "u", "step", "time", "and", "or", "not", "world"};
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  if (name.empty() || name.size() > kLongest) return "a name has 1 to 40 characters.";
  if (!isLetter(name[0])) return "a name begins with a letter.";
  if (!std::all_of(name.begin(), name.end(), [&](char c) { return isLetter(c) || (c >= '0' && c <= '9'); }))
    return "a name has letters a to z, digits and _ only.";
  if (std::find(kTaken.begin(), kTaken.end(), name) != kTaken.end()) return "this word means something already.";
  for (const ExpressionFunction& f : kExpressionFunctions)
    if (f.name == name) return "this is the name of a function.";
  return nullptr;
}

}  // namespace surefoot
