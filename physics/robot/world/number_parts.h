// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of numbersOf(): bodies, joints, motors and ground, each checked as it is evaluated.
#pragma once

#include "physics/robot/world/checked.h"
#include "physics/robot/world/robot_numbers.h"

namespace surefoot {

inline constexpr double kMostOfAnything = 1e9;  ///< of whatever has no better bound

BodyNumbers bodyOf(const BodySpec& spec, double scale, CheckedNumbers& number);
JointNumbers jointOf(const JointSpec& spec, const RobotNumbers& numbers, CheckedNumbers& number);
ActuatorNumbers actuatorOf(const ActuatorSpec& spec, CheckedNumbers& number);
void laidGround(const GroundSpec& spec, RobotNumbers& numbers, CheckedNumbers& number);

/// A vector turned to the left by an angle [rad]; the same bits everywhere.
Point rotated(Point v, double angle);

}  // namespace surefoot
