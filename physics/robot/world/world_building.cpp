// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a robot into Box2D: ground, bodies, shapes, joints.
#include <algorithm>
#include <cmath>

#include "physics/robot/world/masses.h"
#include "physics/robot/world/robot_world.h"
#include "physics/robot/world/world_units.h"

namespace surefoot {

using namespace robot_units;

namespace {

constexpr std::uint16_t kGround = 1, kMeetsGround = 2, kMeetsAll = 4;

}  // namespace

void RobotWorld::addGround() {
  const b2BodyDef def;
  ground_ = world_.CreateBody(&def);
  if (!numbers_.hasGround) return;
  b2FixtureDef fixture;
  fixture.friction = single(numbers_.groundFriction);
  fixture.filter.categoryBits = kGround;
  if (numbers_.ground.empty()) {
    constexpr double kHalfLength = 500;  // [m]
    b2PolygonShape box;
    box.SetAsBox(single(scale_ * kHalfLength), 1.0f, b2Vec2(0.0f, -1.0f), 0.0f);
    fixture.shape = &box;
    ground_->CreateFixture(&fixture);
    return;
  }
  // A chain is solid to the right of its direction: from right to left it carries what stands on it.
  std::vector<b2Vec2> line;
  for (auto p = numbers_.ground.rbegin(); p != numbers_.ground.rend(); ++p) line.push_back(inside(*p));
  const b2Vec2 before = line.front() + (line.front() - line[1]),
               after = line.back() + (line.back() - line[line.size() - 2]);
  b2ChainShape chain;
  chain.CreateChain(line.data(), static_cast<int32>(line.size()), before, after);
  fixture.shape = &chain;
  ground_->CreateFixture(&fixture);
}

void RobotWorld::addBody(int index) {
  const BodyNumbers& numbers = numbers_.bodies[static_cast<std::size_t>(index)];
  const BodySpec& spec = robot_.bodies[static_cast<std::size_t>(index)];
  b2BodyDef def;
  def.type = numbers.still ? b2_staticBody : b2_dynamicBody;
  def.position = inside(numbers.at);
  def.angle = single(numbers.angle);
  b2Body& body = *bodies_.emplace_back(world_.CreateBody(&def));
  for (std::size_t i = 0; i < numbers.shapes.size(); ++i) {
    solid_.push_back(1);
    if (spec.shapes[i].solid) solids_.push_back({&spec.shapes[i].solid->expression, solid_.size() - 1});
    if (numbers.shapes[i].meets != Meets::Nothing) addShape(body, numbers.shapes[i], solid_.size());
  }
  if (numbers.still) return;
  if (!numbers.rotates) body.SetFixedRotation(true);  // before the mass: it resets it, as shapes do
  const b2MassData mass{single(numbers.mass), inside(numbers.centre),
                        numbers.rotates ? single(scale_ * scale_ * numbers.inertiaAtOrigin) : 0.0f};
  body.SetMassData(&mass);
}

void RobotWorld::addShape(b2Body& body, const ShapeNumbers& shape, std::size_t number) {
  b2FixtureDef fixture;
  fixture.friction = single(shape.friction);
  fixture.restitution = single(shape.restitution);
  fixture.userData.pointer = number;
  const bool all = shape.meets == Meets::All;
  fixture.filter.categoryBits = all ? kMeetsAll : kMeetsGround;
  fixture.filter.maskBits = all ? kGround | kMeetsAll : kGround;
  b2CircleShape circle;
  const auto addCircle = [&](Point at) {
    circle.m_radius = single(scale_ * shape.radius);
    circle.m_p = inside(at);
    fixture.shape = &circle;
    body.CreateFixture(&fixture);
  };
  if (shape.kind == ShapeSpec::Kind::Circle) return addCircle(shape.at);
  std::vector<b2Vec2> corners;
  for (const Point corner : cornersOf(shape)) corners.push_back(inside(corner));
  b2PolygonShape polygon;
  polygon.Set(corners.data(), static_cast<int32>(corners.size()));
  fixture.shape = &polygon;
  body.CreateFixture(&fixture);
  if (shape.kind == ShapeSpec::Kind::Rod) addCircle(shape.at), addCircle(shape.to);
}

void RobotWorld::addJoint(int index) {
  using Joins = JointSpec::Kind;
  const JointSpec& spec = robot_.joints[static_cast<std::size_t>(index)];
  const JointNumbers& numbers = numbers_.joints[static_cast<std::size_t>(index)];
  Joint& joint = joints_.emplace_back();
  joint.parent = bodyOf(spec.parent), joint.child = bodyOf(spec.child);
  bool velocity = false;
  for (const ActuatorSpec& actuator : robot_.actuators)
    if (actuator.joint == index) {
      joint.drives |= actuator.kind != ActuatorSpec::Kind::Velocity;
      velocity |= actuator.kind == ActuatorSpec::Kind::Velocity;
    }
  const b2Vec2 a = inside(numbers.atParent), b = inside(numbers.atChild);
  const auto made = [&](b2JointDef& def) {
    def.bodyA = joint.parent, def.bodyB = joint.child;
    return joint.joint = world_.CreateJoint(&def);
  };
  if (spec.kind == Joins::Revolute && !numbers.soft) {
    b2RevoluteJointDef def;
    def.localAnchorA = a, def.localAnchorB = b, def.referenceAngle = single(numbers.turned);
    if (numbers.limits) {
      def.enableLimit = true;
      def.lowerAngle = single(numbers.limits->first), def.upperAngle = single(numbers.limits->second);
    }
    def.enableMotor = velocity || numbers.friction > 0.0;
    def.maxMotorTorque = velocity ? 0.0f : single(scale_ * scale_ * numbers.friction);
    made(def);
  } else if (spec.kind == Joins::Revolute || spec.kind == Joins::Weld) {
    b2WeldJointDef def;
    def.localAnchorA = a, def.localAnchorB = b, def.referenceAngle = single(numbers.turned);
    if (spec.kind == Joins::Revolute) {
      joint.weld = static_cast<b2WeldJoint*>(made(def));
      joint.drives = true;
    } else {
      made(def);
    }
  } else if (spec.kind == Joins::Prismatic) {
    b2PrismaticJointDef def;
    def.localAnchorA = a, def.localAnchorB = b, def.referenceAngle = single(numbers.turned);
    def.localAxisA = b2Vec2(single(numbers.axis.x), single(numbers.axis.y));
    if (numbers.limits && !spec.stop) {
      def.enableLimit = true;
      def.lowerTranslation = single(scale_ * numbers.limits->first);
      def.upperTranslation = single(scale_ * numbers.limits->second);
    }
    def.enableMotor = velocity || numbers.friction > 0.0;
    def.maxMotorForce = velocity ? 0.0f : single(scale_ * numbers.friction);
    joint.prismatic = static_cast<b2PrismaticJoint*>(made(def));
    joint.drives |= numbers.damping > 0.0 || numbers.stiffness > 0.0 || spec.stop.has_value();
    const double sum = full(joint.parent->GetMass() > 0.0f ? 1.0f / joint.parent->GetMass() : 0.0f) +
                       full(joint.child->GetMass() > 0.0f ? 1.0f / joint.child->GetMass() : 0.0f);
    joint.reduced = sum > 0.0 ? 1.0 / sum : 1.0;
  } else if (spec.kind == Joins::Wheel) {
    b2WheelJointDef def;
    def.localAnchorA = a, def.localAnchorB = b;
    def.localAxisA = b2Vec2(single(numbers.axis.x), single(numbers.axis.y));
    def.stiffness = single(numbers.stiffness), def.damping = single(numbers.damping);
    if (numbers.limits) {
      def.enableLimit = true;
      def.lowerTranslation = single(scale_ * numbers.limits->first);
      def.upperTranslation = single(scale_ * numbers.limits->second);
    }
    def.enableMotor = velocity || numbers.friction > 0.0;
    def.maxMotorTorque = velocity ? 0.0f : single(scale_ * scale_ * numbers.friction);
    made(def);
  } else {
    b2DistanceJointDef def;
    def.localAnchorA = a, def.localAnchorB = b;
    def.length = single(scale_ * numbers.length);
    def.minLength = def.maxLength = def.length;
    if (numbers.limits)
      def.minLength = single(scale_ * numbers.limits->first), def.maxLength = single(scale_ * numbers.limits->second);
    def.stiffness = single(numbers.stiffness), def.damping = single(numbers.damping);
    made(def);
  }
}

}  // namespace surefoot
