// SPDX-License-Identifier: GPL-3.0-or-later
// The equations of motion of the pendulum on a cart, integrated by the classical fourth-order Runge-Kutta method: the
// yardstick for the Box2D world. Independent of it but for the constants.
//
//   (M_e + m)·ẍ + m·l·(α̈ cos α − α̇² sin α) = F            F = (T − c·β̇)/R, β̇ = ẋ/R
//   (I + m·l²)·α̈ + m·l·ẍ cos α − m·g·l sin α = −friction     l = L/2, I = m·L²/12
// (Barto, Sutton & Anderson 1983 with a rod; α clockwise positive.) Dry friction is Coulomb's, made continuous over
// ± 1e-3 rad/s so that the method keeps its order.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "physics/pendulum/pendulum_settings.h"

namespace surefoot {

class PendulumReference {
 public:
  using Vector = Eigen::Vector4d;  // x, ẋ, α, α̇

  PendulumReference(const PendulumSettings& s, double poleAngle) : s_(s), y_(0.0, 0.0, poleAngle, 0.0) {}

  /// Moves on by `seconds` under a constant wheel torque [N m].
  void advance(double torque, double seconds) {
    constexpr double kLongest = 1e-4;  // [s]
    const int pieces = static_cast<int>(std::ceil(seconds / kLongest));
    const double h = seconds / pieces;
    for (int i = 0; i < pieces; ++i) {
      const Vector k1 = slope(y_, torque);
      const Vector k2 = slope(y_ + h / 2 * k1, torque);
      const Vector k3 = slope(y_ + h / 2 * k2, torque);
      const Vector k4 = slope(y_ + h * k3, torque);
      y_ += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
  }

  double poleAngle() const { return y_[2]; }
  double poleRate() const { return y_[3]; }
  double wheelRate() const { return y_[1] / s_.wheelRadius; }

  /// Kinetic and potential energy [J].
  double energy() const {
    const double m = s_.poleMass, l = s_.poleLength / 2, v = y_[1], w = y_[3], a = y_[2];
    return 0.5 * (effectiveMass() + m) * v * v + m * l * v * w * std::cos(a) + 0.5 * (inertia() + m * l * l) * w * w +
           m * 9.81 * l * std::cos(a);
  }

 private:
  double effectiveMass() const { return s_.baseMass + s_.wheelMass * 1.5; }  // M + m_w + (½ m_w R²)/R²
  double inertia() const { return s_.poleMass * s_.poleLength * s_.poleLength / 12; }

  Vector slope(const Vector& y, double torque) const {
    const double m = s_.poleMass, l = s_.poleLength / 2, r = s_.wheelRadius;
    const double sine = std::sin(y[2]), cosine = std::cos(y[2]);
    const double force = (torque - s_.damping * y[1] / r) / r;
    const double friction = -s_.friction * std::clamp(y[3] / 1e-3, -1.0, 1.0);
    Eigen::Matrix2d mass;
    mass << effectiveMass() + m, m * l * cosine, m * l * cosine, inertia() + m * l * l;
    const Eigen::Vector2d push(force + m * l * y[3] * y[3] * sine, m * 9.81 * l * sine + friction);
    const Eigen::Vector2d acceleration = mass.inverse() * push;
    return {y[1], acceleration[0], y[3], acceleration[1]};
  }

  PendulumSettings s_;
  Vector y_;
};

}  // namespace surefoot
