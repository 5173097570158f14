// SPDX-License-Identifier: GPL-3.0-or-later
// The Box2D side of the pendulum: owns the bodies; the only file with Box2D pointers.
#pragma once

#include <box2d/box2d.h>

#include "physics/pendulum/pendulum_settings.h"

namespace surefoot {

class PendulumWorld {
 public:
  static constexpr double kStepTime = 0.005;  // [s], a transition (thesis, section 3.1.2)
  static constexpr double kGravity = 9.81;    // [m/s²]

  explicit PendulumWorld(const PendulumSettings& settings);

  /// A clean state: x = 0, and nothing left of the joints' impulses. Angles clockwise positive.
  void place(double poleAngle, double poleRate, double wheelRate);
  /// One transition under a wheel torque [N m].
  void step(double torque);

  /// A horizontal impulse [N s] at the tip of the pole, to the right.
  void push(double impulse);

  double x() const;          // [m]
  double poleAngle() const;  // [rad], clockwise positive
  double poleRate() const;   // [rad/s]
  double wheelRate() const;  // [rad/s]
  /// Kinetic energy of cart and pole, and what gravity gave the pole, 0 upright [J].
  double energy() const;

  /// The time that Box2D measured for its last step [ms]; 0 as long as box2d_clock.cpp is linked in.
  float profiledStep() const { return world_.GetProfile().step; }

 private:
  // Without contacts 4 velocity and 1 position iterations are as exact as the customary 8 and 3. Without friction 1 and
  // 1 are, too: against the equations they err by 0.0146 rad after 125 ms, 4 and 1 by 0.0142, all of it the time
  // step's. With friction 1 is not enough, and without position iterations the joints drift apart.
  static constexpr int kVelocityIterations = 1, kFrictionIterations = 4;
  static constexpr int kPositionIterations = 1;

  b2World world_;
  b2Body* base_ = nullptr;
  b2Body* pole_ = nullptr;
  int substeps_;
  float substepTime_;
  double radius_, damping_, poleLength_;
  double forcePerTorque_;  // 1/(R·(1 + h·c/(M_t·R²))) [1/m]
  bool fresh_ = true;      // placed, not stepped yet
  bool motor_ = false;     // the hinge has friction
};

}  // namespace surefoot
