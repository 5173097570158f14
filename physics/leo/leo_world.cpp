// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/leo/leo_world.h"

#include <algorithm>
#include <cmath>

#include "physics/world/walking.h"

namespace surefoot {

using namespace leo;

namespace {

constexpr double kSlowest = 0.05;  // [rad/s]: below this rate, dry friction acts as a damper
constexpr double kFree = 1e-6;     // stiffness of a weld that does not weld: Box2D wants more than 0

float f(double x) {
  return static_cast<float>(x);
}

Vec rotated(Vec v, double angle) {
  return {v.x * std::cos(angle) - v.y * std::sin(angle), v.x * std::sin(angle) + v.y * std::cos(angle)};
}

/// The origin of a child whose anchor lies on the anchor of its parent.
Vec hangOn(Vec parent, double parentAngle, const JointKind& kind, double childAngle) {
  const Vec anchor = rotated(kind.inParent, parentAngle), own = rotated(kind.inChild, childAngle);
  return {parent.x + anchor.x - own.x, parent.y + anchor.y - own.y};
}

Body thigh(int leg) {
  return static_cast<Body>(kLeftThigh + leg);
}
Body shank(int leg) {
  return static_cast<Body>(kLeftShank + leg);
}
Body foot(int leg) {
  return static_cast<Body>(kLeftFoot + leg);
}

}  // namespace

LeoWorld::LeoWorld(const LeoSettings& s, const Angles& angles, const Angles& rates, double x)
    : settings_(s),
      world_(b2Vec2(0.0f, f(-kScale * s.gravity))) {
  const double kG = s.torqueConstant * s.gearRatio, perVolt = s.efficiency * kG / s.resistance;
  const double inertia = s.armature * s.substeps / kStepTime;
  drive_ = {perVolt, perVolt * kG + inertia, inertia};
  const Anatomy& a = settings_.anatomy;
  world_.SetAllowSleeping(false);
  world_.SetContinuousPhysics(false);

  // From the torso down, then lifted until the lowest circle is on the floor.
  std::array<Vec, kBodies> at{};
  at[kTorso] = {x - rotated(a.hip.inParent, angles[kTorso]).x, 0.0};
  for (int leg = 0; leg < 2; ++leg) {
    at[thigh(leg)] = hangOn(at[kTorso], angles[kTorso], a.hip, angles[thigh(leg)]);
    at[shank(leg)] = hangOn(at[thigh(leg)], angles[thigh(leg)], a.knee, angles[shank(leg)]);
    at[foot(leg)] = hangOn(at[shank(leg)], angles[shank(leg)], a.ankle, angles[foot(leg)]);
  }
  double lowest = 1e9;
  const auto low = [&](Body body, const Circle& circle) {
    lowest = std::min(lowest, at[body].y + rotated(circle.centre, angles[body]).y - circle.radius);
  };
  low(kTorso, a.seat);
  for (int leg = 0; leg < 2; ++leg) low(shank(leg), a.kneeCap), low(foot(leg), a.heel), low(foot(leg), a.toe);
  for (Vec& origin : at) origin.y -= lowest;

  addFloor(world_, kScale, s.grip);

  // Box2D visits bodies from the last one on, and joints as it comes to them. From the torso outwards its weight gets
  // down to the feet within one iteration; from a foot upwards it takes several times as many to hold grip 10.
  for (int leg = 0; leg < 2; ++leg) {
    addBody(thigh(leg), at[thigh(leg)], angles[thigh(leg)]);
    addBody(shank(leg), at[shank(leg)], angles[shank(leg)]);
    addBody(foot(leg), at[foot(leg)], angles[foot(leg)]);
    addCircle(shank(leg), a.kneeCap);
    addCircle(foot(leg), a.heel);
    addCircle(foot(leg), a.toe);
  }
  addBody(kTorso, at[kTorso], angles[kTorso]);
  addCircle(kTorso, a.seat);
  for (int leg = 0; leg < 2; ++leg) {
    addJoint(static_cast<Joint>(kLeftHip + leg), kTorso, thigh(leg), a.hip);
    addJoint(static_cast<Joint>(kLeftKnee + leg), thigh(leg), shank(leg), a.knee);
    addJoint(static_cast<Joint>(kLeftAnkle + leg), shank(leg), foot(leg), a.ankle);
  }

  // The masses are set after the fixtures, which set them too; then the rates, so that no joint is torn.
  const auto setMass = [&](Body body, const Mass& m) {
    const double aboutOrigin = m.inertia + m.mass * (m.centre.x * m.centre.x + m.centre.y * m.centre.y);
    const b2MassData data{
        f(m.mass), {f(kScale * m.centre.x), f(kScale * m.centre.y)}, f(kScale * kScale * aboutOrigin)};
    bodies_[body]->SetMassData(&data);
  };
  setMass(kTorso, a.torso);
  for (int leg = 0; leg < 2; ++leg) {
    setMass(thigh(leg), a.thigh);
    setMass(shank(leg), a.shank);
    setMass(foot(leg), a.foot);
  }

  // Everything turns about the foot that stands lower, whose origin is at rest.
  const auto spin = [&](Body body, b2Vec2 anchor, b2Vec2 velocity) {
    b2Body* b = bodies_[body];
    const b2Vec2 arm = b->GetWorldCenter() - anchor;
    b->SetAngularVelocity(f(rates[body]));
    b->SetLinearVelocity(velocity + b2Cross(f(rates[body]), arm));
  };
  const int stands = at[foot(0)].y <= at[foot(1)].y ? 0 : 1;
  b2Vec2 hold = bodies_[foot(stands)]->GetPosition(), moves = b2Vec2_zero;
  const auto anchorOf = [&](Joint joint) { return joints_[joint].joint->GetAnchorA(); };
  const auto carried = [&](Body body, b2Vec2 from, b2Vec2 velocity, b2Vec2 to) {
    return velocity + b2Cross(f(rates[body]), to - from);
  };
  for (const auto& [body, joint] : {std::pair{foot(stands), static_cast<Joint>(kLeftAnkle + stands)},
                                    std::pair{shank(stands), static_cast<Joint>(kLeftKnee + stands)},
                                    std::pair{thigh(stands), static_cast<Joint>(kLeftHip + stands)}}) {
    spin(body, hold, moves);
    moves = carried(body, hold, moves, anchorOf(joint));
    hold = anchorOf(joint);
  }
  spin(kTorso, hold, moves);
  const int other = 1 - stands;
  for (const auto& [body, joint] : {std::pair{thigh(other), static_cast<Joint>(kLeftKnee + other)},
                                    std::pair{shank(other), static_cast<Joint>(kLeftAnkle + other)}}) {
    spin(body, hold, moves);
    moves = carried(body, hold, moves, anchorOf(joint));
    hold = anchorOf(joint);
  }
  spin(foot(other), hold, moves);
}

void LeoWorld::addBody(Body body, Vec origin, double angle) {
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position = {f(kScale * origin.x), f(kScale * origin.y)};
  def.angle = f(angle);
  bodies_[body] = world_.CreateBody(&def);
}

void LeoWorld::addCircle(Body body, const Circle& circle) {
  b2CircleShape shape;
  shape.m_radius = f(kScale * circle.radius);
  shape.m_p = {f(kScale * circle.centre.x), f(kScale * circle.centre.y)};
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.friction = f(settings_.grip);
  fixture.restitution = 0.0f;
  fixture.filter.groupIndex = kRobotGroup;
  bodies_[body]->CreateFixture(&fixture);
}

void LeoWorld::addJoint(Joint joint, Body parent, Body child, const JointKind& kind) {
  b2WeldJointDef def;
  def.bodyA = bodies_[parent];
  def.bodyB = bodies_[child];
  def.localAnchorA = {f(kScale * kind.inParent.x), f(kScale * kind.inParent.y)};
  def.localAnchorB = {f(kScale * kind.inChild.x), f(kScale * kind.inChild.y)};
  def.referenceAngle = 0.0f;
  def.stiffness = f(kFree);
  def.damping = 0.0f;
  joints_[joint] = {static_cast<b2WeldJoint*>(world_.CreateJoint(&def)), bodies_[parent], bodies_[child], &kind};
}

void LeoWorld::drive(Joint joint, double voltage) {
  const Hinge& hinge = joints_[joint];
  const double angle = jointAngle(joint), rate = jointRate(joint);

  double torque = drive_.perVolt * voltage + drive_.inertia * rate;
  double damping = drive_.damping + settings_.dryFriction / std::max(std::abs(rate), kSlowest);
  double stiffness = kFree;
  const double limit = angle < hinge.kind->low ? hinge.kind->low : hinge.kind->high;
  if (angle < hinge.kind->low || angle > hinge.kind->high) {
    stiffness = std::max(kFree, hinge.kind->stopStiffness);
    damping += hinge.kind->stopDamping;
    torque += stiffness * limit;  // the weld's own angle of rest is 0
  }
  constexpr double kInside = kScale * kScale;
  hinge.joint->SetStiffness(f(kInside * stiffness));
  hinge.joint->SetDamping(f(kInside * damping));
  hinge.child->ApplyTorque(f(kInside * torque), true);
  hinge.parent->ApplyTorque(f(-kInside * torque), true);
}

double LeoWorld::step(const Voltages& wanted) {
  const double h = kStepTime / settings_.substeps;
  const double kG = settings_.torqueConstant * settings_.gearRatio;
  Voltages u = wanted;
  Voltages rateBefore{};
  for (std::size_t j = 0; j < kJoints; ++j) {
    u[j] = std::clamp(u[j], -settings_.voltage, settings_.voltage);
    rateBefore[j] = jointRate(static_cast<Joint>(j));
  }
  voltages_ = u;
  for (int i = 0; i < settings_.substeps; ++i) {
    for (int j = 0; j < kJoints; ++j) drive(static_cast<Joint>(j), u[static_cast<std::size_t>(j)]);
    bodies_[kTorso]->ApplyForce({0.0f, f(kScale * settings_.boomForce)},
                                bodies_[kTorso]->GetWorldPoint({f(kScale * settings_.anatomy.boomPoint.x),
                                                                f(kScale * settings_.anatomy.boomPoint.y)}),
                                true);
    world_.Step(f(h), kVelocityIterations, kPositionIterations);
  }
  double energy = 0.0;  // the rate is the mean of before and after, as in leosim
  for (std::size_t j = 0; j < kLeftAnkle; ++j) {
    const double rate = 0.5 * (rateBefore[j] + jointRate(static_cast<Joint>(j)));
    energy += std::max(0.0, u[j] * (u[j] - kG * rate) / settings_.resistance) * kStepTime;
  }
  return energy;
}

void LeoWorld::push(double impulse) {
  bodies_[kTorso]->ApplyLinearImpulse({f(kScale * impulse), 0.0f},
                                      bodies_[kTorso]->GetWorldPoint({f(kScale * settings_.anatomy.hip.inParent.x),
                                                                      f(kScale * settings_.anatomy.hip.inParent.y)}),
                                      true);
}

double LeoWorld::jointAngle(Joint joint) const {
  return static_cast<double>(joints_[joint].child->GetAngle()) - static_cast<double>(joints_[joint].parent->GetAngle());
}
double LeoWorld::jointRate(Joint joint) const {
  return static_cast<double>(joints_[joint].child->GetAngularVelocity()) -
         static_cast<double>(joints_[joint].parent->GetAngularVelocity());
}

Vec LeoWorld::worldPoint(Body body, Vec point) const {
  const b2Vec2 p = bodies_[body]->GetWorldPoint({f(kScale * point.x), f(kScale * point.y)});
  return {static_cast<double>(p.x) / kScale, static_cast<double>(p.y) / kScale};
}
Vec LeoWorld::hip() const {
  return worldPoint(kTorso, settings_.anatomy.hip.inParent);
}
Vec LeoWorld::ankle(int leg) const {
  return worldPoint(foot(leg), settings_.anatomy.ankle.inChild);
}

bool LeoWorld::onFloor(int leg) const {
  for (const b2ContactEdge* edge = bodies_[foot(leg)]->GetContactList(); edge; edge = edge->next)
    if (edge->contact->IsTouching()) return true;
  return false;
}

bool LeoWorld::touches(int leg, bool heel) const {
  const b2Body* body = bodies_[foot(leg)];
  for (const b2ContactEdge* edge = body->GetContactList(); edge; edge = edge->next) {
    if (!edge->contact->IsTouching()) continue;
    const b2Fixture *a = edge->contact->GetFixtureA(), *b = edge->contact->GetFixtureB();
    const auto* circle = static_cast<const b2CircleShape*>((a->GetBody() == body ? a : b)->GetShape());
    if ((circle->m_p.x < 0) == heel) return true;  // a foot has two circles, the heel behind its ankle
  }
  return false;
}

double LeoWorld::current(Joint joint) const {
  const double backEmf = settings_.torqueConstant * settings_.gearRatio * jointRate(joint);
  return (voltages_[joint] - backEmf) / settings_.resistance;
}

double LeoWorld::hipSpeed() const {
  const Vec& at = settings_.anatomy.hip.inParent;
  return static_cast<double>(bodies_[kTorso]->GetLinearVelocityFromLocalPoint({f(kScale * at.x), f(kScale * at.y)}).x) /
         kScale;
}

double LeoWorld::jointSeparation() const {
  double most = 0.0;
  for (const Hinge& hinge : joints_)
    most = std::max(most, static_cast<double>((hinge.joint->GetAnchorA() - hinge.joint->GetAnchorB()).Length()));
  return most / kScale;
}

}  // namespace surefoot
