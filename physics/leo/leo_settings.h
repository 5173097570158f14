// SPDX-License-Identifier: GPL-3.0-or-later
// Every constant of the walking robot LEO that can be set. Facts from the same laboratory's published simulation
// (wcaarls/grl, addons/leosim); the code is ours.
#pragma once

#include "physics/leo/leo_body.h"

namespace surefoot {

struct LeoSettings {
  // The motors: Dynamixel RX-28, six of them (torque constant k, gear ratio G).
  double resistance = 8.6;          ///< R of the windings [Ω]
  double torqueConstant = 0.00992;  ///< k [N m/A]
  double gearRatio = 193.0;         ///< G
  double armature = 0.002414;       ///< reflected inertia of the rotor [kg m²]
  double efficiency = 0.75;         ///< η of the gears
  double dryFriction = 0.20;        ///< dry friction of a joint [N m]
  double voltage = 10.69;           ///< the largest voltage [V]

  double boomForce = -1.0269;  ///< vertical force of the boom [N]
  double grip = 10.0;          ///< friction of feet and floor
  int substeps = 19;           ///< Box2D steps per transition
  double hipTarget = 0.68;     ///< angle between the hips that the hand-made controller aims at [rad]
  double gravity = 9.81;       ///< [m/s²]

  leo::Anatomy anatomy;

  // The joints that control themselves.
  double stanceKneeGain = 21.21, ankleGain = 42.42;  ///< [V/rad], towards 0 and the ankles' target
  double ankleTarget = 0.0649262481741891;           ///< 3.72° [rad]

  // When it is doomed: the lean of the torso, of the stance thigh [rad].
  double mostTorso = 1.0, mostStanceThigh = 1.1309733552923256;

  // The task.
  double timeReward = -1.0;       ///< per step
  double energyReward = -3.0;     ///< per joule
  double footstepReward = 300.0;  ///< per metre by which the ankles move apart
  double fallReward = -125.0;     ///< when doomed
  int levels = 7;                 ///< levels of each voltage
  int testEvery = 10;             ///< episodes between two greedy tests
  int maxSteps = 750;             ///< steps of an episode at most: 25 s

  void declare(Fields& f);
};

}  // namespace surefoot
