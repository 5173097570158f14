// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/world/robot_world.h"

#include <algorithm>
#include <cmath>

#include "physics/robot/world/world_units.h"

namespace surefoot {

using namespace robot_units;

RobotWorld::RobotWorld(const RobotSpec& robot, const RobotNumbers& numbers)
    : robot_(robot),
      numbers_(numbers),
      world_(b2Vec2(single(numbers.scale * numbers.gravity.x), single(numbers.scale * numbers.gravity.y))),
      substepTime_(single(numbers.stepTime / numbers.substeps)),
      scale_(numbers.scale),
      h_(numbers.stepTime / numbers.substeps) {
  world_.SetAllowSleeping(false);
  world_.SetContinuousPhysics(false);
  addGround();
  for (std::size_t i = 0; i < numbers.bodies.size(); ++i) addBody(static_cast<int>(i));
  for (std::size_t i = 0; i < numbers.joints.size(); ++i) addJoint(static_cast<int>(i));
  drives_.resize(joints_.size());
  efforts_.assign(robot.actuators.size(), 0.0);
  if (!solids_.empty()) world_.SetContactListener(this);
  addProbes();
}

b2Vec2 RobotWorld::inside(Point v) const {
  return {single(scale_ * v.x), single(scale_ * v.y)};
}

void RobotWorld::place(const std::vector<BodyPlacement>& placements) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyPlacement& to = placements[i];
    b2Body& body = *bodies_[i];
    body.SetTransform(inside(to.at), single(to.angle));
    if (body.GetType() == b2_staticBody) continue;
    // Box2D's velocity of a body is the velocity of its centre of mass: the origin's plus ω × r.
    const b2Vec2 arm = body.GetWorldCenter() - body.GetPosition();
    const float omega = single(to.rate);
    body.SetAngularVelocity(omega);
    body.SetLinearVelocity(
        b2Vec2(single(scale_ * to.velocity.x) - omega * arm.y, single(scale_ * to.velocity.y) + omega * arm.x));
  }
  std::fill(efforts_.begin(), efforts_.end(), 0.0);
  fresh_ = true;
}

bool RobotWorld::substep(std::span<double> values, std::span<const double> u) {
  readForSubstep(values, u);
  for (const Solid& solid : solids_) solid_[solid.shape] = solid.expression->holds(values);
  std::fill(drives_.begin(), drives_.end(), Drive{});
  for (std::size_t i = 0; i < efforts_.size(); ++i)
    if (!actuate(i, values, u[i])) return false;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if (!joints_[j].drives) continue;
    if (joints_[j].weld)
      driveSoft(j);
    else if (joints_[j].prismatic)
      driveSlide(j);
    else
      driveHard(j);
  }
  world_.SetWarmStarting(!fresh_);
  world_.Step(substepTime_, numbers_.velocityIterations, numbers_.positionIterations);
  fresh_ = false;
  return sound();
}

bool RobotWorld::actuate(std::size_t index, std::span<double> values, double u) {
  using Drives = ActuatorSpec::Kind;
  const ActuatorSpec& spec = robot_.actuators[index];
  const ActuatorNumbers& numbers = numbers_.actuators[index];
  double effort = spec.effort ? (*spec.effort)(values) : u;
  const double most = spec.limit ? (*spec.limit)(values) : kInfinity;
  if (!std::isfinite(effort) || std::isnan(most)) return false;
  if (spec.kind == Drives::Velocity) return driveVelocity(index, effort, most);
  if (spec.joint < 0) {
    efforts_[index] = effort = std::clamp(effort, -most, most);
    b2Body& body = *bodies_[static_cast<std::size_t>(robot_.points[static_cast<std::size_t>(spec.point)].body)];
    const Point force{effort * numbers.direction.x, effort * numbers.direction.y};
    body.ApplyForce(inside(force), body.GetWorldPoint(inside(numbers_.points[static_cast<std::size_t>(spec.point)])),
                    true);
    return true;
  }
  Drive& drive = drives_[static_cast<std::size_t>(spec.joint)];
  double stiffness = 0.0, damping = 0.0;
  if (spec.kind == Drives::DcMotor) {
    effort = numbers.perVolt * std::clamp(effort, -most, most);
    damping = numbers.damping;
  } else if (spec.kind == Drives::Position) {
    const double off = effort - jointPosition(spec.joint), wanted = numbers.stiffness * off;
    if (std::abs(wanted) <= most) {
      stiffness = numbers.stiffness;
      effort *= stiffness;
    } else {
      effort = std::copysign(most, wanted);
    }
    damping = numbers.damping;
  } else {
    effort = std::clamp(effort, -most, most);
  }
  efforts_[index] = effort;
  drive.effort += effort, drive.damping += damping, drive.stiffness += stiffness;
  return true;
}

bool RobotWorld::driveVelocity(std::size_t index, double speed, double most) {
  const auto j = static_cast<std::size_t>(robot_.actuators[index].joint);
  if (auto* revolute = robot_.joints[j].kind == JointSpec::Kind::Revolute
                           ? static_cast<b2RevoluteJoint*>(joints_[j].joint)
                           : nullptr) {
    revolute->SetMotorSpeed(single(speed));
    revolute->SetMaxMotorTorque(single(scale_ * scale_ * most));
    efforts_[index] = static_cast<double>(revolute->GetMotorTorque(1.0f / substepTime_)) / (scale_ * scale_);
  } else if (joints_[j].prismatic) {
    joints_[j].prismatic->SetMotorSpeed(single(scale_ * speed));
    joints_[j].prismatic->SetMaxMotorForce(single(scale_ * most));
    efforts_[index] = static_cast<double>(joints_[j].prismatic->GetMotorForce(1.0f / substepTime_)) / scale_;
  } else {
    auto* wheel = static_cast<b2WheelJoint*>(joints_[j].joint);
    wheel->SetMotorSpeed(single(speed));
    wheel->SetMaxMotorTorque(single(scale_ * scale_ * most));
    efforts_[index] = static_cast<double>(wheel->GetMotorTorque(1.0f / substepTime_)) / (scale_ * scale_);
  }
  return std::isfinite(efforts_[index]);
}

// The angle of the weld is solved implicitly, so dampers, springs, the rotor's inertia J and dry friction F stay
// stable:
//   damping = D + J/h + F/max(abs(ω), 0.05),   torque from outside = effort + (J/h)·ω + K·rest
void RobotWorld::driveSoft(std::size_t j) {
  constexpr double kSlowest = 0.05;  // [rad/s]: below this rate, dry friction acts as a damper
  constexpr double kFree = 1e-6;     // stiffness of a weld that does not weld: Box2D wants more than 0
  const JointNumbers& joint = numbers_.joints[j];
  const double angle = jointPosition(static_cast<int>(j)), rate = jointRate(static_cast<int>(j));
  double torque = drives_[j].effort + joint.armature / h_ * rate + joint.stiffness * joint.rest;
  double damping = drives_[j].damping + joint.damping + joint.armature / h_;
  if (joint.friction > 0.0) damping += joint.friction / std::max(std::abs(rate), kSlowest);
  double stiffness = drives_[j].stiffness + joint.stiffness;
  if (joint.limits && (angle < joint.limits->first || angle > joint.limits->second)) {
    stiffness += joint.stopStiffness;
    damping += joint.stopDamping;
    torque += joint.stopStiffness * (angle < joint.limits->first ? joint.limits->first : joint.limits->second);
  }
  const double square = scale_ * scale_;
  joints_[j].weld->SetStiffness(single(square * std::max(stiffness, kFree)));
  joints_[j].weld->SetDamping(single(square * damping));
  joints_[j].child->ApplyTorque(single(square * torque), true);
  joints_[j].parent->ApplyTorque(single(-square * torque), true);
}

// F/(1 + h (D + h K)/m): implicit in the speed, exact for two bodies.
void RobotWorld::driveSlide(std::size_t j) {
  const JointNumbers& joint = numbers_.joints[j];
  const double position = jointPosition(static_cast<int>(j));
  double damping = drives_[j].damping + joint.damping, stiffness = drives_[j].stiffness + joint.stiffness;
  double force = drives_[j].effort;
  if (damping > 0.0 || stiffness > 0.0 || joint.stopStiffness > 0.0) {
    force -= stiffness * position - joint.stiffness * joint.rest;
    const bool beyond =
        robot_.joints[j].stop && joint.limits && (position < joint.limits->first || position > joint.limits->second);
    if (beyond) {
      stiffness += joint.stopStiffness, damping += joint.stopDamping;
      force -= joint.stopStiffness *
               (position - (position < joint.limits->first ? joint.limits->first : joint.limits->second));
    }
    force -= damping * jointRate(static_cast<int>(j));
    force /= 1.0 + h_ * (damping + h_ * stiffness) / joints_[j].reduced;
  }
  b2Body &parent = *joints_[j].parent, &child = *joints_[j].child;
  const b2Vec2 axis = parent.GetWorldVector(joints_[j].prismatic->GetLocalAxisA());
  const b2Vec2 along = single(scale_ * force) * axis;
  const b2Vec2 point = joints_[j].joint->GetAnchorB();
  child.ApplyForce(along, point, true);
  if (parent.GetType() == b2_dynamicBody) parent.ApplyForce(-along, point, true);
}

void RobotWorld::driveHard(std::size_t j) {
  const double torque = scale_ * scale_ * drives_[j].effort;
  joints_[j].child->ApplyTorque(single(torque), true);
  joints_[j].parent->ApplyTorque(single(-torque), true);
}

bool RobotWorld::sound() const {
  constexpr float kFarthest = 1e5f;  // in Box2D's units
  for (const b2Body* body : bodies_) {
    const b2Vec2 p = body->GetPosition(), v = body->GetLinearVelocity();
    // Written so that what is no number fails, too.
    if (!(std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest)) return false;
    if (!(v.LengthSquared() < kFarthest * kFarthest) || !(std::abs(body->GetAngularVelocity()) < kFarthest) ||
        !(std::abs(body->GetAngle()) < kFarthest))
      return false;
  }
  return true;
}

void RobotWorld::push(int point, double impulse) {
  b2Body& body = *bodies_[static_cast<std::size_t>(robot_.points[static_cast<std::size_t>(point)].body)];
  body.ApplyLinearImpulse(b2Vec2(single(scale_ * impulse), 0.0f),
                          body.GetWorldPoint(inside(numbers_.points[static_cast<std::size_t>(point)])), true);
}

void RobotWorld::PreSolve(b2Contact* contact, const b2Manifold*) {
  for (b2Fixture* fixture : {contact->GetFixtureA(), contact->GetFixtureB()}) {
    const auto shape = fixture->GetUserData().pointer;
    if (shape > 0 && !solid_[shape - 1]) contact->SetEnabled(false);
  }
}

}  // namespace surefoot
