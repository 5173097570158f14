// SPDX-License-Identifier: GPL-3.0-or-later
// A robot's numbers under the parameters of this moment, all within what Box2D can bear. SI units.
#pragma once

#include <optional>
#include <vector>

#include "core/scene.h"
#include "physics/robot/spec/robot_spec.h"

namespace surefoot {

struct ShapeNumbers {
  ShapeSpec::Kind kind = ShapeSpec::Kind::Circle;
  double radius = 0.0;
  Point size{}, at{}, to{};
  double angle = 0.0;
  std::vector<Point> corners{};
  double friction = 0.0, restitution = 0.0;
  Meets meets = Meets::Nothing;
};

struct BodyNumbers {
  Point at{};
  double angle = 0.0;
  double mass = 0.0, inertiaAtOrigin = 0.0;  ///< [kg], [kg m²]
  Point centre{};                            ///< of mass, in its frame
  bool rotates = true, still = false;
  std::vector<ShapeNumbers> shapes{};

  double inertiaAtCentre() const { return inertiaAtOrigin - mass * (centre.x * centre.x + centre.y * centre.y); }
};

struct JointNumbers {
  Point atParent{}, atChild{};  ///< in the bodies' frames
  Point axis{};                 ///< in the parent's frame, of length 1
  double turned = 0.0;          ///< the child's angle in the parent's frame, in the drawing
  double length = 0.0;          ///< of a distance, in the drawing
  std::optional<std::pair<double, double>> limits{};
  double stopStiffness = 0.0, stopDamping = 0.0;
  double damping = 0.0, armature = 0.0, stiffness = 0.0, rest = 0.0, friction = 0.0;
  bool soft = false;  ///< a weld with a soft angle in place of a revolute joint
};

struct ActuatorNumbers {
  double perVolt = 0.0;  ///< of a DC motor: torque without turning, A = η k G/R [N m/V]
  double damping = 0.0;  ///< and its back-EMF, D = η (k G)²/R; a position servo's own [N m s/rad]
  double stiffness = 0.0;
  double emf = 0.0, resistance = 1.0;  ///< k G [V s/rad], R [Ω]: for its power
  Point direction{};
};

struct RobotNumbers {
  double stepTime = 0.0, scale = 1.0;
  int substeps = 1, velocityIterations = 8, positionIterations = 3;
  Point gravity{};
  std::vector<BodyNumbers> bodies{};
  std::vector<JointNumbers> joints{};
  std::vector<ActuatorNumbers> actuators{};
  std::vector<Point> points{};
  std::vector<std::pair<double, double>> rays{};  ///< angle, length
  std::vector<Point> ground{};                    ///< from left to right; empty: none, or flat at height 0
  bool hasGround = false, anythingMeets = false;
  double groundFriction = 1.0;

  /// Height of the ground at x; 0 where there is none.
  double groundAt(double x) const;
};

/// The numbers under `values`; complaints: what is not allowed. Then the result is of no use.
RobotNumbers numbersOf(const RobotSpec& robot, std::span<const double> values, std::vector<Complaint>& complaints);

}  // namespace surefoot
