// SPDX-License-Identifier: GPL-3.0-or-later
// Lets a robot move at random and by itself, and says what is doubtful in its file. Takes some tenths of a second; any
// thread.
#pragma once

#include <memory>

#include "core/environment_inspection.h"
#include "physics/robot/child/child_robot.h"

namespace surefoot {

/// Of a robot that checkRobot() finds nothing wrong with; `child`: if a program moves it.
EnvironmentInspection inspectRobot(const std::shared_ptr<const RobotSpec>& spec,
                                   std::unique_ptr<ChildRobot> child = nullptr);

}  // namespace surefoot
