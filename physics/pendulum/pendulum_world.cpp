// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/pendulum/pendulum_world.h"

#include <cmath>

namespace surefoot {

namespace {
float f(double x) {
  return static_cast<float>(x);
}
}  // namespace

PendulumWorld::PendulumWorld(const PendulumSettings& s)
    : world_(b2Vec2(0.0f, f(-kGravity))),
      substeps_(s.substeps),
      substepTime_(f(kStepTime / s.substeps)),
      radius_(s.wheelRadius),
      damping_(s.damping),
      poleLength_(s.poleLength) {
  world_.SetAllowSleeping(false);
  world_.SetContinuousPhysics(false);

  const double wheelInertia = 0.5 * s.wheelMass * radius_ * radius_;                           // solid cylinder
  const double effectiveMass = s.baseMass + s.wheelMass + wheelInertia / (radius_ * radius_);  // M_e
  const double totalMass = effectiveMass + s.poleMass;                                         // M_t
  const double h = kStepTime / s.substeps;
  forcePerTorque_ = 1.0 / (radius_ * (1.0 + h * damping_ / (totalMass * radius_ * radius_)));

  b2BodyDef groundDef;
  b2Body* ground = world_.CreateBody(&groundDef);

  b2BodyDef baseDef;
  baseDef.type = b2_dynamicBody;
  base_ = world_.CreateBody(&baseDef);
  base_->SetFixedRotation(true);  // before the mass: it resets it
  const b2MassData baseMass{f(effectiveMass), b2Vec2_zero, 0.0f};
  base_->SetMassData(&baseMass);

  b2BodyDef poleDef;
  poleDef.type = b2_dynamicBody;
  poleDef.angularDamping = 0.0f;
  pole_ = world_.CreateBody(&poleDef);
  // Box2D takes the inertia about the body's origin, the hinge: a uniform rod, m·L²/3.
  const b2MassData poleMass{f(s.poleMass), b2Vec2(0.0f, f(poleLength_ / 2)),
                            f(s.poleMass * poleLength_ * poleLength_ / 3)};
  pole_->SetMassData(&poleMass);

  b2PrismaticJointDef rail;
  rail.Initialize(ground, base_, b2Vec2_zero, b2Vec2(1.0f, 0.0f));
  world_.CreateJoint(&rail);

  b2RevoluteJointDef hinge;
  hinge.Initialize(base_, pole_, b2Vec2_zero);
  if (s.friction > 0.0) {
    hinge.enableMotor = motor_ = true;
    hinge.motorSpeed = 0.0f;
    hinge.maxMotorTorque = f(s.friction);
  }
  world_.CreateJoint(&hinge);
}

void PendulumWorld::place(double poleAngle, double poleRate, double wheelRate) {
  const float speed = f(wheelRate * radius_);
  base_->SetTransform(b2Vec2_zero, 0.0f);
  base_->SetLinearVelocity(b2Vec2(speed, 0.0f));
  pole_->SetTransform(b2Vec2_zero, f(-poleAngle));
  // Box2D's velocity of a body is the velocity of its centre of mass: the hinge's velocity plus ω × r.
  const b2Vec2 arm = pole_->GetWorldCenter() - pole_->GetPosition();
  const float omega = f(-poleRate);
  pole_->SetAngularVelocity(omega);
  pole_->SetLinearVelocity(b2Vec2(speed - omega * arm.y, omega * arm.x));
  fresh_ = true;
}

void PendulumWorld::step(double torque) {
  for (int i = 0; i < substeps_; ++i) {
    const double force = (torque - damping_ * wheelRate()) * forcePerTorque_;
    base_->ApplyForceToCenter(b2Vec2(f(force), 0.0f), true);
    world_.SetWarmStarting(!fresh_);  // the impulses of the last episode belong to another state
    world_.Step(substepTime_, motor_ ? kFrictionIterations : kVelocityIterations, kPositionIterations);
    fresh_ = false;
  }
}

void PendulumWorld::push(double impulse) {
  pole_->ApplyLinearImpulse(b2Vec2(f(impulse), 0.0f), pole_->GetWorldPoint(b2Vec2(0.0f, f(poleLength_))), true);
}

double PendulumWorld::x() const {
  return static_cast<double>(base_->GetPosition().x);
}
double PendulumWorld::poleAngle() const {
  return -static_cast<double>(pole_->GetAngle());
}
double PendulumWorld::poleRate() const {
  return -static_cast<double>(pole_->GetAngularVelocity());
}
double PendulumWorld::wheelRate() const {
  return static_cast<double>(base_->GetLinearVelocity().x) / radius_;
}

double PendulumWorld::energy() const {
  const auto kinetic = [](const b2Body& body) {
    const double v2 = static_cast<double>(body.GetLinearVelocity().LengthSquared());
    const double w = static_cast<double>(body.GetAngularVelocity());
    const double arm2 = static_cast<double>(body.GetLocalCenter().LengthSquared());
    const double mass = static_cast<double>(body.GetMass());
    const double inertia = static_cast<double>(body.GetInertia()) - mass * arm2;  // about its centre
    return 0.5 * mass * v2 + 0.5 * inertia * w * w;
  };
  const double height = static_cast<double>(pole_->GetWorldCenter().y) - poleLength_ / 2;
  return kinetic(*base_) + kinetic(*pole_) + static_cast<double>(pole_->GetMass()) * kGravity * height;
}

}  // namespace surefoot
