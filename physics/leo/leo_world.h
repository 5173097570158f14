// SPDX-License-Identifier: GPL-3.0-or-later
// The Box2D side of LEO. Lengths are ten times as large inside; masses and time are as they are, so forces are ×10,
// torques, inertias and angular stiffness and damping ×100.
//
// A joint is a weld whose angle is soft: that row is solved implicitly, so the motor's back-EMF D, the inertia J of its
// rotor and dry friction F_c stay stable at a few substeps of length h:
//
//   damping = D + J/h + F_c/max(abs(ω), 0.05),   torque from outside = A·U + (J/h)·ω_old
//
// with A = η k G/R and D = η (k G)²/R. Beyond a limit the row is the spring and damper of the stop.
#pragma once

#include <box2d/box2d.h>

#include <array>

#include "physics/leo/leo_body.h"
#include "physics/leo/leo_settings.h"

namespace surefoot {

class LeoWorld {
 public:
  static constexpr double kStepTime = 1.0 / 30.0;  // [s]
  using Angles = std::array<double, leo::kBodies>;
  using Voltages = std::array<double, leo::kJoints>;

  /// The bodies stand at these angles and turn at these rates, the lowest circle on the floor; the hip at x.
  LeoWorld(const LeoSettings& settings, const Angles& angles, const Angles& rates, double x = 0.0);

  /// One transition under these voltages [V], which are limited to ± the largest. Returns the electric energy that the
  /// hips and knees took [J].
  double step(const Voltages& voltages);
  /// A horizontal impulse at the torso's hip [N s].
  void push(double impulse);

  double angle(leo::Body body) const { return static_cast<double>(bodies_[body]->GetAngle()); }
  double rate(leo::Body body) const { return static_cast<double>(bodies_[body]->GetAngularVelocity()); }
  double jointAngle(leo::Joint joint) const;
  double jointRate(leo::Joint joint) const;
  leo::Vec hip() const;           // [m]
  leo::Vec ankle(int leg) const;  // [m]
  bool onFloor(int leg) const;    // heel or toe touches
  /// Of the last step: what each motor got [V], its current [A] and the electric power that it took [W], at the end.
  double voltage(leo::Joint joint) const { return voltages_[joint]; }
  double current(leo::Joint joint) const;
  double power(leo::Joint joint) const { return voltages_[joint] * current(joint); }
  bool touches(int leg, bool heel) const;
  double hipSpeed() const;  // forward [m/s]
  /// The largest distance between the two ends of any joint [m].
  double jointSeparation() const;

 private:
  static constexpr double kScale = 10.0;
  static constexpr int kVelocityIterations = 14, kPositionIterations = 3;

  void addBody(leo::Body body, leo::Vec origin, double angle);
  void addCircle(leo::Body body, const leo::Circle& circle);
  void addJoint(leo::Joint joint, leo::Body parent, leo::Body child, const leo::JointKind& kind);
  void drive(leo::Joint joint, double voltage);
  leo::Vec worldPoint(leo::Body body, leo::Vec point) const;  // [m]

  struct Hinge {
    b2WeldJoint* joint;
    b2Body *parent, *child;
    const leo::JointKind* kind;
  };

  /// Constants of the drive, the same for every motor and substep.
  struct Drive {
    double perVolt;  // A [N m/V]
    double damping;  // D + J/h [N m s/rad]
    double inertia;  // J/h [N m s/rad]
  };

  LeoSettings settings_;
  Drive drive_;
  b2World world_;
  std::array<b2Body*, leo::kBodies> bodies_{};
  std::array<Hinge, leo::kJoints> joints_{};
  Voltages voltages_{};  // of the last step
};

}  // namespace surefoot
