// SPDX-License-Identifier: GPL-3.0-or-later
// Every constant of the pendulum on a cart, with its origin: thesis (Avoiding failure states during Reinforcement
// Learning, chapter 3 and table 4.1), lab file (the same laboratory's published simulation, wcaarls/grl,
// addons/odesim/cfg/robot.xml) or calibrated (fitted by us to episode lengths that the thesis reports).
#pragma once

#include <numbers>

#include "core/parameters.h"

namespace surefoot {

struct PendulumSettings {
  static constexpr double kPi = std::numbers::pi;

  // The model.
  double damping = 0.08;                   ///< c of the wheel motors: torque = −c·(wheel rate) [N m s/rad]
  double friction = 0.0;                   ///< Coulomb friction on the pole's hinge [N m]
  double torqueScale = 1.0;                ///< multiplies every action
  double poleLength = 0.10;                ///< [m]
  double poleMass = 1.0;                   ///< uniform rod [kg]
  double baseMass = 1.2;                   ///< without the wheel [kg]
  double wheelRadius = 0.05;               ///< [m]
  double wheelMass = 0.5;                  ///< solid cylinder [kg]
  double startAngle = 15.0 / 180.0 * kPi;  ///< starts are uniform in ± this [rad]
  int substeps = 1;                        ///< Box2D steps per transition

  // The task.
  double goalReward = 200.0;
  double fallReward = -100.0;
  double timeReward = 0.0;             ///< per step (eq. 4.3)
  double fallAngle = 0.45 * kPi;       ///< [rad]
  double balancedAngle = 0.005 * kPi;  ///< [rad]
  double balancedRate = 0.005 * kPi;   ///< [rad/s]
  int maxSteps = 4000;

  // The representation: one span of the wheel rate holds as many tiles as its resolution says.
  double wheelSpan = 20.0;  ///< [rad/s]

  void declare(Fields& f);
};

}  // namespace surefoot
