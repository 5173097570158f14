// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/compass/compass_world.h"

#include <cmath>

#include "physics/world/walking.h"

namespace surefoot {

namespace {

float f(double x) {
  return static_cast<float>(x);
}

/// The leg whose foot touches the floor.
int legOf(b2Contact& contact) {
  b2Fixture* a = contact.GetFixtureA();
  b2Fixture* robot = a->GetFilterData().groupIndex == kRobotGroup ? a : contact.GetFixtureB();
  return static_cast<int>(robot->GetUserData().pointer);
}

}  // namespace

CompassWorld::CompassWorld(const CompassSettings& s, const Posture& posture, double x)
    : settings_(s),
      world_(b2Vec2(f(kScale * s.gravity * std::sin(s.slope)), f(-kScale * s.gravity * std::cos(s.slope)))) {
  world_.SetAllowSleeping(false);
  world_.SetContinuousPhysics(false);
  world_.SetContactListener(this);

  addFloor(world_, kScale, s.friction);

  const double toFoot = s.legLength - s.footRadius;  // the centre of the foot's circle
  const double sole = s.footRadius;
  const double hipY = toFoot * std::cos(posture.stance) + sole;
  const double hipX = x - toFoot * std::sin(posture.stance);
  // The stance leg turns about the point where its foot touches the floor.
  const double vx = -posture.stanceRate * hipY, vy = posture.stanceRate * (hipX - x);

  const double half = 0.5 * s.legLength;
  const double mass = s.legMass + 0.5 * s.hipMass, centre = s.legMass * half / mass;  // below the hip
  const double inertia = s.legInertia + s.legMass * half * half;                      // about the hip
  for (int leg = 0; leg < 2; ++leg) {
    const double angle = leg == stance_ ? posture.stance : posture.swing;
    const double rate = leg == stance_ ? posture.stanceRate : posture.swingRate;
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position = {f(kScale * hipX), f(kScale * hipY)};
    def.angle = f(angle);
    b2Body* body = legs_[static_cast<std::size_t>(leg)] = world_.CreateBody(&def);
    b2CircleShape circle;
    circle.m_radius = f(kScale * s.footRadius);
    circle.m_p = {0.0f, f(-kScale * toFoot)};
    b2FixtureDef fixture;
    fixture.shape = &circle;
    fixture.friction = f(s.friction);
    fixture.filter.groupIndex = kRobotGroup;
    fixture.userData.pointer = static_cast<std::uintptr_t>(leg);
    body->CreateFixture(&fixture);
    const b2MassData data{f(mass), {0.0f, f(-kScale * centre)}, f(kScale * kScale * inertia)};
    body->SetMassData(&data);  // after the fixture, because the fixture sets it too
    const b2Vec2 arm = body->GetWorldCenter() - body->GetPosition();
    body->SetAngularVelocity(f(rate));
    body->SetLinearVelocity(
        {f(kScale * vx - rate * static_cast<double>(arm.y)), f(kScale * vy + rate * static_cast<double>(arm.x))});
  }
  b2RevoluteJointDef hip;
  hip.Initialize(legs_[0], legs_[1], legs_[0]->GetPosition());
  world_.CreateJoint(&hip);
}

b2Vec2 CompassWorld::foot(int leg) const {
  return legs_[static_cast<std::size_t>(leg)]->GetWorldPoint(
      {0.0f, f(-kScale * (settings_.legLength - settings_.footRadius))});
}

double CompassWorld::footX(int leg) const {
  return static_cast<double>(foot(leg).x) / kScale;
}

void CompassWorld::decideSolid() {
  const Posture p = posture();
  if (p.swing - p.stance < settings_.solidFrom)
    solid_ = false;
  else if (static_cast<double>(foot(1 - stance_).y) > kScale * settings_.footRadius)
    solid_ = true;
}

// Legs without knees would scuff: the swing foot passes through the floor until it is in front. Where it then meets the
// floor the legs change their roles at once, so that the foot behind is free and takes no part in the strike.
void CompassWorld::PreSolve(b2Contact* contact, const b2Manifold*) {
  const int leg = legOf(*contact);
  if (leg == stance_) return;
  if (!solid_) return contact->SetEnabled(false);
  struck_ = true;
  stance_ = leg;
  solid_ = false;
  for (b2Contact* other = world_.GetContactList(); other; other = other->GetNext())
    if (legOf(*other) != leg) other->SetEnabled(false);  // it may have been asked before
}

double CompassWorld::step(double torque) {
  double length = 0.0;
  for (int i = 0; i < settings_.substeps; ++i) length += substep(torque);
  return length;
}

double CompassWorld::substep(double torque) {
  decideSolid();
  struck_ = false;
  const auto inside = f(torque * kScale * kScale);
  legs_[static_cast<std::size_t>(1 - stance_)]->ApplyTorque(inside, true);
  legs_[static_cast<std::size_t>(stance_)]->ApplyTorque(-inside, true);
  world_.Step(f(kStepTime / settings_.substeps), kVelocityIterations, kPositionIterations);
  if (!struck_) return 0.0;
  return footX(stance_) - footX(1 - stance_);
}

void CompassWorld::push(double impulse) {
  legs_[0]->ApplyLinearImpulse({f(kScale * impulse), 0.0f}, legs_[0]->GetPosition(), true);
}

CompassWorld::Posture CompassWorld::posture() const {
  const b2Body& stance = *legs_[static_cast<std::size_t>(stance_)];
  const b2Body& swing = *legs_[static_cast<std::size_t>(1 - stance_)];
  return {static_cast<double>(stance.GetAngle()), static_cast<double>(stance.GetAngularVelocity()),
          static_cast<double>(swing.GetAngle()), static_cast<double>(swing.GetAngularVelocity())};
}

double CompassWorld::hipX() const {
  return static_cast<double>(legs_[0]->GetPosition().x) / kScale;
}
double CompassWorld::hipY() const {
  return static_cast<double>(legs_[0]->GetPosition().y) / kScale;
}

double CompassWorld::angularMomentum(double x) const {
  double sum = 0.0;
  for (const b2Body* leg : legs_) {
    const b2Vec2 r = leg->GetWorldCenter() - b2Vec2(f(kScale * x), 0.0f), v = leg->GetLinearVelocity();
    const double about =
        static_cast<double>(leg->GetInertia()) -
        static_cast<double>(leg->GetMass()) * static_cast<double>(leg->GetLocalCenter().LengthSquared());
    sum += static_cast<double>(leg->GetMass()) * static_cast<double>(b2Cross(r, v)) +
           about * static_cast<double>(leg->GetAngularVelocity());
  }
  return sum / (kScale * kScale);
}

}  // namespace surefoot
