// SPDX-License-Identifier: GPL-3.0-or-later
// A robot left to itself.
#pragma once

#include "core/environment_inspection.h"
#include "physics/robot/robot.h"

namespace surefoot {

/// The robot without anything that takes or gives energy but gravity; its substeps times `finer`.
std::shared_ptr<const RobotSpec> passiveRobot(const RobotSpec& spec, int finer);

/// The robot as it is drawn, a little above the ground.
std::shared_ptr<const RobotSpec> droppedRobot(const RobotSpec& spec);

/// From its start, for some seconds.
PassiveEnergy energyOf(const std::shared_ptr<const RobotSpec>& passive);

}  // namespace surefoot
