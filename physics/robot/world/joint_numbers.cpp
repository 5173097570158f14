// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/basics/portable_math.h"
#include "physics/robot/world/checked.h"
#include "physics/robot/world/number_parts.h"

namespace surefoot {

namespace {

/// A place of the drawing in a body's frame.
Point inBody(const BodyNumbers* body, Point at) {
  return body ? rotated({at.x - body->at.x, at.y - body->at.y}, -body->angle) : at;
}

/// The resistance of the two bodies to what moves a joint: their inertias or masses, one behind the other.
double reducedMass(const JointSpec& spec, const BodyNumbers* parent, const BodyNumbers& child) {
  const bool turns = spec.kind == JointSpec::Kind::Revolute;
  const auto inverse = [&](const BodyNumbers* body) {
    if (!body || body->still || (turns && !body->rotates)) return 0.0;
    return 1.0 / (turns ? body->inertiaAtOrigin : body->mass);
  };
  const double sum = inverse(parent) + inverse(&child);
  return sum > 0.0 ? 1.0 / sum : 1.0;
}

}  // namespace

JointNumbers jointOf(const JointSpec& spec, const RobotNumbers& numbers, CheckedNumbers& number) {
  using Joins = JointSpec::Kind;
  const std::string where = fmt::format("[joint.{}]", spec.name);
  const BodyNumbers* parent = spec.parent < 0 ? nullptr : &numbers.bodies[static_cast<std::size_t>(spec.parent)];
  const BodyNumbers& child = numbers.bodies[static_cast<std::size_t>(spec.child)];
  JointNumbers joint;
  const Point at = number.at(spec.at, where, "at");
  const Point end = spec.kind == Joins::Distance ? number.at(spec.to, where, "to") : at;
  joint.atParent = inBody(parent, at), joint.atChild = inBody(&child, end);
  joint.turned = child.angle - (parent ? parent->angle : 0.0);
  joint.length = length({end.x - at.x, end.y - at.y});
  const double shortest = 0.005 / numbers.scale;
  if (spec.kind == Joins::Distance && joint.length < shortest)
    number.complain(spec.place, fmt::format("{}: its ends are {} m apart; at least {} m are needed.", where,
                                            joint.length, shortest));
  const Point axis = number.at(spec.axis, where, "axis");
  if (length(axis) < 1e-6) number.complain(spec.place, where + ": its axis has no direction.");
  joint.axis = rotated({axis.x / length(axis), axis.y / length(axis)}, parent ? -parent->angle : 0.0);

  const auto optional = [&](const std::optional<Formula>& formula, const char* what) {
    return formula ? number(*formula, where, what, 0, kMostOfAnything) : 0.0;
  };
  joint.damping = optional(spec.damping, "damping");
  joint.armature = optional(spec.armature, "armature");
  joint.stiffness = optional(spec.stiffness, "stiffness");
  joint.friction = number(spec.friction, where, "friction", 0, kMostOfAnything);
  joint.rest = number(spec.rest, where, "rest", -1e4, 1e4);
  joint.soft = spec.soft || spec.damping || spec.armature || spec.stiffness || spec.stop;
  if (spec.limits) {
    const double low = number((*spec.limits)[0], where, "limits", -1e4, 1e4);
    const double high = number((*spec.limits)[1], where, "limits", -1e4, 1e4);
    if (low > high)
      number.complain((*spec.limits)[0].at,
                      fmt::format("{}: limits: the lowest, {}, is above the highest, {}.", where, low, high));
    joint.limits = {std::min(low, high), std::max(low, high)};
    // A soft joint stops at limits that are as stiff as a substep can bear.
    const double h = numbers.stepTime / numbers.substeps, inertia = reducedMass(spec, parent, child);
    joint.stopStiffness =
        spec.stop ? number((*spec.stop)[0], where, "stop", 0, kMostOfAnything) : 0.04 * inertia / (h * h);
    joint.stopDamping = spec.stop ? number((*spec.stop)[1], where, "stop", 0, kMostOfAnything) : 0.4 * inertia / h;
  }
  return joint;
}

ActuatorNumbers actuatorOf(const ActuatorSpec& spec, CheckedNumbers& number) {
  const std::string where = fmt::format("[actuator.{}]", spec.name);
  ActuatorNumbers actuator;
  actuator.stiffness = number(spec.stiffness, where, "stiffness", 0, kMostOfAnything);
  actuator.damping = number(spec.damping, where, "damping", 0, kMostOfAnything);
  if (spec.kind == ActuatorSpec::Kind::DcMotor) {
    actuator.resistance = number(spec.resistance, where, "resistance", 1e-6, 1e6, "Ω");
    const double efficiency = number(spec.efficiency, where, "efficiency", 0, 1);
    actuator.emf = number(spec.torqueConstant, where, "torque_constant", 0, 1e6, "N m/A") *
                   number(spec.gear, where, "gear", 1e-6, 1e6);
    actuator.perVolt = efficiency * actuator.emf / actuator.resistance;
    actuator.damping = efficiency * actuator.emf * actuator.emf / actuator.resistance;
  }
  actuator.direction = number.at(spec.direction, where, "direction");
  for (const Formula& level : spec.levels)
    static_cast<void>(number(level, where, "levels", -kMostOfAnything, kMostOfAnything, spec.unit));
  return actuator;
}

}  // namespace surefoot
