// SPDX-License-Identifier: GPL-3.0-or-later
// What moves in a robot from a file: its bodies that touch things, its joints, its actuators, and the energy of all.
#include <algorithm>

#include "physics/robot/robot.h"

namespace surefoot {

namespace {

std::string keyOf(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

bool canTouch(const BodySpec& body) {
  return std::any_of(body.shapes.begin(), body.shapes.end(),
                     [](const ShapeSpec& shape) { return shape.meets != Meets::Nothing; });
}

bool slides(const JointSpec& joint) {
  return joint.kind == JointSpec::Kind::Prismatic || joint.kind == JointSpec::Kind::Distance;
}

/// A name as a person reads it.
std::string titleOf(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace

std::vector<Signal> Robot::signals() const {
  std::vector<Signal> all;
  const auto add = [&](const std::string& name, const char* what, const std::string& unit, const char* group) {
    all.push_back({.key = keyOf(name + "_" + what), .title = titleOf(name) + " " + what, .unit = unit, .group = group});
  };
  for (const BodySpec& body : spec().bodies) {
    if (body.still) continue;
    add(body.name, "x", "m", "motion");
    add(body.name, "y", "m", "motion");
  }
  for (const BodySpec& body : spec().bodies)
    if (!body.still && canTouch(body))
      all.push_back({.key = keyOf(body.name),
                     .title = titleOf(body.name) + " touches",
                     .group = "contacts",
                     .kind = Signal::Kind::OnOff});
  for (const JointSpec& joint : spec().joints) {
    if (joint.kind == JointSpec::Kind::Weld) continue;
    add(joint.name, slides(joint) ? "distance" : "angle", slides(joint) ? "m" : "rad", "motion");
    add(joint.name, "rate", slides(joint) ? "m/s" : "rad/s", "motion");
  }
  for (const ActuatorSpec& actuator : spec().actuators) {
    const bool turns = actuator.joint >= 0 && !slides(spec().joints[static_cast<std::size_t>(actuator.joint)]);
    add(actuator.name, "level", actuator.unit, "motors");
    add(actuator.name, "effort", turns ? "N m" : "N", "motors");
    add(actuator.name, "power", "W", "motors");
  }
  if (spec().actuators.size() > 1)
    all.push_back({.key = "power", .title = "power of all motors", .unit = "W", .group = "motors"});
  all.push_back({.key = "mechanical_energy", .title = "energy of all bodies", .unit = "J", .group = "motion"});
  return all;
}

void Robot::readSignals(std::span<double> values) const {
  std::size_t i = 0;
  const auto index = [](std::size_t n) { return static_cast<int>(n); };
  for (std::size_t b = 0; b < spec().bodies.size(); ++b) {
    if (spec().bodies[b].still) continue;
    const BodyPlacement body = world_->placement(index(b));
    values[i++] = body.at.x;
    values[i++] = body.at.y;
  }
  for (std::size_t b = 0; b < spec().bodies.size(); ++b)
    if (!spec().bodies[b].still && canTouch(spec().bodies[b])) values[i++] = world_->touches(index(b));
  for (std::size_t j = 0; j < spec().joints.size(); ++j) {
    if (spec().joints[j].kind == JointSpec::Kind::Weld) continue;
    values[i++] = world_->jointPosition(index(j));
    values[i++] = world_->jointRate(index(j));
  }
  double power = 0.0;
  for (std::size_t a = 0; a < spec().actuators.size(); ++a) {
    values[i++] = values_.levels()[a];
    values[i++] = world_->effort(index(a));
    values[i++] = world_->power(index(a), values_.levels()[a]);
    power += values[i - 1];
  }
  if (spec().actuators.size() > 1) values[i++] = power;
  values[i++] = world_->energy();
}

}  // namespace surefoot
