// SPDX-License-Identifier: GPL-3.0-or-later
// Lets a robot move at random and by itself, and says what is doubtful in its file. Takes some tenths of a second; any
// thread.
#pragma once

#include <memory>

#include "core/environment_inspection.h"
#include "physics/robot/spec/robot_spec.h"

namespace surefoot {

/// Of a robot that checkRobot() finds nothing wrong with.
EnvironmentInspection inspectRobot(const std::shared_ptr<const RobotSpec>& spec);

}  // namespace surefoot
