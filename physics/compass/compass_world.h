// SPDX-License-Identifier: GPL-3.0-or-later
// The Box2D side of the compass walker. Lengths are ten times as large inside, so that feet are well above Box2D's
// contact slop; masses and time are as they are, so forces are ×10, inertias and torques ×100.
#pragma once

#include <box2d/box2d.h>

#include <array>
#include <optional>

#include "physics/compass/compass_settings.h"

namespace surefoot {

class CompassWorld final : private b2ContactListener {
 public:
  static constexpr double kStepTime = 0.04;  // [s]

  /// Angles of the legs from the vertical, the foot forward positive [rad], and their rates [rad/s].
  struct Posture {
    double stance = 0, stanceRate = 0, swing = 0, swingRate = 0;
  };

  /// Stands with the stance foot on the floor at x.
  CompassWorld(const CompassSettings& settings, const Posture& posture, double x = 0.0);

  /// One transition under a hip torque [N m]: + on the swing leg, − on the stance leg. Returns the length of a
  /// footstep [m], from the old stance foot to the new one; 0 without a footstep.
  double step(double torque);
  /// One substep of a transition, kStepTime/substeps long.
  double substep(double torque);
  /// A horizontal impulse at the hip [N s].
  void push(double impulse);

  Posture posture() const;
  double hipX() const;  // [m]
  double hipY() const;
  int stanceLeg() const { return stance_; }
  /// Angular momentum of everything about a point of the floor [kg m²/s], counter-clockwise.
  double angularMomentum(double x) const;
  double footX(int leg) const;

 private:
  static constexpr double kScale = 10.0;
  static constexpr int kVelocityIterations = 6, kPositionIterations = 3;

  void PreSolve(b2Contact* contact, const b2Manifold* old) override;
  void decideSolid();
  b2Vec2 foot(int leg) const;  // its centre, in Box2D's lengths

  CompassSettings settings_;
  b2World world_;
  std::array<b2Body*, 2> legs_{};
  int stance_ = 0;
  bool solid_ = false;   // the swing foot
  bool struck_ = false;  // it met the floor in this substep
};

}  // namespace surefoot
