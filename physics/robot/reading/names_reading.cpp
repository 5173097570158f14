// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/printable.h"
#include "core/text/text.h"
#include "physics/robot/reading/sections.h"

namespace surefoot {

namespace {

void addName(RobotReader& in, NameKind kind, const std::string& name, TextPlace at) {
  if (const char* why = wrongName(name))
    in.complaints().push_back({at, fmt::format("\"{}\": {}", printable(shortened(name)), why)});
  if (!in.spec().names.add(kind, name))
    in.complaints().push_back(
        {at, fmt::format("there is another \"{}\" already; bodies, points, joints, actuators, states and constants "
                         "share one space of names.",
                         printable(shortened(name)))});
}

void limitNames(const TomlNode& all, std::string_view heading, std::size_t count, int most, RobotReader& in) {
  if (count > static_cast<std::size_t>(most))
    in.complaints().push_back({all.at, fmt::format("{}: {} of them; at most {} are allowed.", heading, count, most)});
}

/// [body.NAME], [joint.NAME] …: the tables under a heading.
void addTables(const TomlNode& root, std::string_view heading, NameKind kind, int most, RobotReader& in) {
  const TomlNode* all = root.find(heading);
  if (!all || all->kind != TomlNode::Kind::Table) return;
  limitNames(*all, heading, all->table.size(), most, in);
  for (const auto& [name, node] : all->table) addName(in, kind, name, node.keyAt);
}

/// [[state]] …: the tables of a list, each with a key.
void addKeys(const TomlNode& root, std::string_view heading, NameKind kind, int most, RobotReader& in) {
  const TomlNode* all = root.find(heading);
  if (!all || all->kind != TomlNode::Kind::List) return;
  limitNames(*all, heading, all->list.size(), most, in);
  for (const TomlNode& node : all->list) {
    const TomlNode* key = node.find("key");
    if (key && key->kind == TomlNode::Kind::Text)
      addName(in, kind, key->text, key->at);
    else
      in.complaints().push_back({node.at, fmt::format("[[{}]] needs a key: its name.", heading)});
  }
}

void addShapeNames(const TomlNode& root, RobotReader& in) {
  const TomlNode* bodies = root.find("body");
  if (!bodies) return;
  for (const auto& [name, body] : bodies->table) {
    std::vector<std::string> shapes;
    const TomlNode* list = body.find("shape");
    for (const TomlNode& shape : list ? list->list : std::vector<TomlNode>{}) {
      const TomlNode* own = shape.find("name");
      shapes.push_back(own ? own->text : "");
    }
    in.spec().names.addShapes(std::move(shapes));
  }
}

}  // namespace

void collectNames(const TomlNode& root, RobotReader& in) {
  addKeys(root, "parameter", NameKind::Parameter, kMostParameters, in);
  addTables(root, "constants", NameKind::Constant, kMostNames, in);
  addTables(root, "body", NameKind::Body, kMostBodies, in);
  addTables(root, "point", NameKind::Point, kMostNames, in);
  addTables(root, "joint", NameKind::Joint, kMostJoints, in);
  addTables(root, "actuator", NameKind::Actuator, kMostJoints, in);
  addTables(root, "ray", NameKind::Ray, kMostRays, in);
  addKeys(root, "memory", NameKind::Memory, kMostNames, in);
  addKeys(root, "state", NameKind::State, kMaxStateVariables, in);
  addShapeNames(root, in);
}

}  // namespace surefoot
