// SPDX-License-Identifier: GPL-3.0-or-later
// Every constant of the compass walker. It is invented for teaching, not a real robot; the values are ours.
#pragma once

#include "core/parameters.h"

namespace surefoot {

struct CompassSettings {
  // The model.
  double legLength = 0.45;        ///< from the hip to the sole [m]
  double legMass = 0.5;           ///< its centre in the middle [kg]
  double legInertia = 0.0084375;  ///< about that centre [kg m²]
  double hipMass = 1.0;           ///< half of it on each leg, at the hip [kg]
  double footRadius = 0.02;       ///< [m]
  double friction = 5.0;          ///< friction of feet and floor
  double gravity = 9.81;          ///< [m/s²]
  double solidFrom = 0.1;         ///< the swing foot meets the floor beyond this angle in front of the stance leg [rad]
  double slope = 0.0;             ///< [rad]; below 0 it goes uphill
  double torque = 0.6;            ///< hip torques of the actions: −, 0, + this [N m]
  double startStance = 0.20;      ///< [rad]
  double startRate = -1.4;        ///< rate of the stance leg [rad/s]
  double startSwing = -0.20;      ///< [rad]
  double startNoise = 0.15;       ///< as a share of the three start values; for the swing leg's rate in rad/s
  int substeps = 40;              ///< Box2D steps per transition

  // The task.
  double mostStance = 0.5, mostSwing = 1.0;  ///< beyond one of these angles it has fallen [rad]
  double footstepReward = 200.0;             ///< per metre of a footstep
  double fallReward = -100.0;
  double timeReward = -1.0;  ///< per step
  int testEvery = 10;        ///< episodes between two greedy tests
  int maxSteps = 500;        ///< 20 s

  void declare(Fields& f);
};

}  // namespace surefoot
