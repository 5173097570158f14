// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/reading/sections.h"

namespace surefoot {

namespace {

using JointKind = JointSpec::Kind;
using Drive = ActuatorSpec::Kind;

constexpr std::pair<const char*, JointKind> kJointKinds[] = {{"revolute", JointKind::Revolute},
                                                             {"prismatic", JointKind::Prismatic},
                                                             {"weld", JointKind::Weld},
                                                             {"wheel", JointKind::Wheel},
                                                             {"distance", JointKind::Distance}};
constexpr std::pair<const char*, Drive> kDrives[] = {{"torque", Drive::Torque},
                                                     {"force", Drive::Force},
                                                     {"dc-motor", Drive::DcMotor},
                                                     {"position", Drive::Position},
                                                     {"velocity", Drive::Velocity}};

void readEnds(TomlReader& reader, RobotReader& in, JointSpec& joint) {
  const TomlNode* between = reader.need("between");
  if (!between) return;
  if (between->kind != TomlNode::Kind::List || between->list.size() != 2)
    return reader.complain("between", "it takes two bodies, such as [\"world\", \"cart\"].");
  const TomlNode &parent = between->list[0], &child = between->list[1];
  const bool toWorld = parent.text == "world";
  const auto first = toWorld ? std::nullopt : in.indexOf(parent, NameKind::Body);
  const auto second = in.indexOf(child, NameKind::Body);
  joint.parent = first.value_or(-1), joint.child = second.value_or(0);
  if (first && second && *first == *second) reader.complain("between", "a joint joins two different bodies.");
}

JointSpec readJoint(const std::string& name, const TomlNode& node, RobotReader& in) {
  TomlReader reader(node, in.complaints());
  JointSpec joint{.name = name, .place = node.keyAt};
  joint.kind = in.choice(reader, "type", kJointKinds, JointKind::Revolute);
  readEnds(reader, in, joint);
  joint.at = in.pair(reader, "at", 0, 0);
  const bool hasAxis = reader.find("axis") != nullptr, hasEnd = reader.find("to") != nullptr;
  joint.axis = in.pair(reader, "axis", joint.kind == JointKind::Wheel ? 0 : 1, joint.kind == JointKind::Wheel ? 1 : 0);
  joint.to = in.pair(reader, "to", 0, 0);
  joint.limits = in.maybePair(reader, "limits");
  joint.stop = in.maybePair(reader, "stop");
  joint.damping = in.maybe(reader, "damping");
  joint.armature = in.maybe(reader, "armature");
  joint.stiffness = in.maybe(reader, "stiffness");
  joint.friction = in.number(reader, "friction", 0);
  joint.rest = in.number(reader, "rest", 0);
  joint.soft = reader.flag("soft");
  joint.drawn = reader.flag("drawn", true);
  reader.end();

  const bool slides = joint.kind == JointKind::Prismatic || joint.kind == JointKind::Wheel;
  if (hasAxis && !slides) reader.complain("axis", "only prismatic and wheel joints have one.");
  if (hasEnd != (joint.kind == JointKind::Distance))
    reader.complain("to", "a distance joint has it, the others do not.");
  if (joint.stop && !joint.limits) reader.complain("stop", "it makes limits soft, and there are no limits.");
  return joint;
}

void readDrive(TomlReader& reader, RobotReader& in, ActuatorSpec& actuator) {
  if (actuator.kind == Drive::DcMotor)
    for (const char* key : {"resistance", "torque_constant"}) reader.need(key);
  if (actuator.kind == Drive::Position) reader.need("stiffness");
  if (actuator.kind == Drive::Velocity) reader.need("limit");
  actuator.resistance = in.number(reader, "resistance", 1);
  actuator.torqueConstant = in.number(reader, "torque_constant", 0);
  actuator.gear = in.number(reader, "gear", 1);
  actuator.efficiency = in.number(reader, "efficiency", 1);
  actuator.stiffness = in.number(reader, "stiffness", 0);
  actuator.damping = in.number(reader, "damping", 0);
  const auto only = [&](const char* key, bool allowed, const char* what) {
    if (reader.find(key) && !allowed) reader.complain(key, fmt::format("only {} has it.", what));
  };
  for (const char* key : {"resistance", "torque_constant", "gear", "efficiency"})
    only(key, actuator.kind == Drive::DcMotor, "a dc-motor");
  for (const char* key : {"stiffness", "damping"}) only(key, actuator.kind == Drive::Position, "a position servo");
}

/// Where it acts: at a joint, or with a force at a point.
void readWhere(TomlReader& reader, RobotReader& in, ActuatorSpec& actuator) {
  const TomlNode *joint = reader.find("joint"), *point = reader.find("point");
  actuator.joint = in.indexOf(reader, "joint", NameKind::Joint);
  actuator.point = in.indexOf(reader, "point", NameKind::Point);
  actuator.direction = in.pair(reader, "direction", 1, 0);
  if (!joint == !point)
    in.complaints().push_back({actuator.place, fmt::format("[actuator.{}] acts at a joint or at a point; give one of "
                                                           "them.",
                                                           actuator.name)});
  if (point && actuator.kind != Drive::Force) reader.complain("point", "only a force acts at a point.");
  if (reader.find("direction") && !point) reader.complain("direction", "it belongs to a force at a point.");
}

ActuatorSpec readActuator(const std::string& name, int index, const TomlNode& node, RobotReader& in) {
  using Where = RobotReader::Where;
  TomlReader reader(node, in.complaints());
  ActuatorSpec actuator{.name = name, .place = node.keyAt};
  actuator.title = reader.text("title", name);
  actuator.symbol = reader.text("symbol");
  actuator.unit = reader.text("unit");
  actuator.levels = in.numbers(reader, "levels");
  if (actuator.levels.size() > kMostLevels)
    reader.complain("levels", fmt::format("{} of them; at most {} are allowed.", actuator.levels.size(), kMostLevels));
  actuator.handMade = in.maybe(reader, "hand_made", Where::Moving, ValueKind::Number, index);
  actuator.width = in.maybe(reader, "width");
  if (in.spec().names.hasChild()) {  // the program does with a level what it likes
    reader.need("levels");
    reader.end();
    return actuator;
  }
  actuator.kind = in.choice(reader, "type", kDrives, Drive::Torque);
  readWhere(reader, in, actuator);
  actuator.effort = in.maybe(reader, "effort", Where::Moving, ValueKind::Number, index);
  actuator.limit = in.maybe(reader, "limit", Where::Moving, ValueKind::Number, index);
  readDrive(reader, in, actuator);
  actuator.arrow = in.indexOf(reader, "arrow", NameKind::Point);
  actuator.arrowScale = reader.number("arrow_scale", 0.001, 1000, 1);
  reader.end();
  return actuator;
}

}  // namespace

void readJoints(const TomlNode& root, RobotReader& in) {
  const TomlNode* all = root.find("joint");
  for (const auto& [name, node] : all ? all->table : decltype(all->table){})
    in.spec().joints.push_back(readJoint(name, node, in));
}

void readActuators(const TomlNode& root, RobotReader& in) {
  const TomlNode* all = root.find("actuator");
  std::size_t actions = 1;
  bool acts = false;
  for (const auto& [name, node] : all ? all->table : decltype(all->table){}) {
    auto& actuators = in.spec().actuators;
    actuators.push_back(readActuator(name, static_cast<int>(actuators.size()), node, in));
    if (actuators.back().levels.empty()) continue;
    acts = true;
    actions = std::min<std::size_t>(actions * actuators.back().levels.size(), kMaxActions + 1);
  }
  if (actions > kMaxActions)
    in.complaints().push_back(
        {{1, 1}, fmt::format("the levels of the actuators combine to more than {} actions.", kMaxActions)});
  if (!acts) in.complaints().push_back({{1, 1}, "no actuator has levels: there is nothing to choose."});
}

void readGround(const TomlNode& root, RobotReader& in) {
  using Ground = GroundSpec::Kind;
  static constexpr std::pair<const char*, Ground> kKinds[] = {{"none", Ground::None},
                                                              {"flat", Ground::Flat},
                                                              {"polyline", Ground::Polyline},
                                                              {"steps", Ground::Steps},
                                                              {"bumps", Ground::Bumps}};
  static const TomlNode kEmpty{};
  const TomlNode* node = root.find("ground");
  TomlReader reader(node ? *node : kEmpty, in.complaints());
  GroundSpec& ground = in.spec().ground;
  ground.place = node ? node->at : TextPlace{1, 1};
  ground.kind = in.choice(reader, "type", kKinds, Ground::Flat);
  ground.friction = in.number(reader, "friction", 1);
  ground.slope = in.number(reader, "slope", 0);
  ground.points = in.pairs(reader, "points");
  const bool rough = ground.kind == Ground::Steps || ground.kind == Ground::Bumps;
  if (rough)
    for (const char* key : {"length", "height", "from", "to"}) reader.need(key);
  ground.length = in.number(reader, "length", 1);
  ground.height = in.number(reader, "height", 0);
  ground.from = in.number(reader, "from", 0);
  ground.to = in.number(reader, "to", 1);
  ground.seed = in.number(reader, "seed", 1);
  reader.end();
  if (ground.kind == Ground::Polyline && (ground.points.size() < 2 || ground.points.size() > kMostGroundPoints))
    reader.complain("points",
                    fmt::format("{} of them; a polyline has 2 to {}.", ground.points.size(), kMostGroundPoints));
}

}  // namespace surefoot
