// SPDX-License-Identifier: GPL-3.0-or-later
// Names, handles and the drawing of a robot, for a page that shows it beside its text.
#pragma once

#include "core/environment_inspection.h"
#include "physics/robot/robot.h"

namespace surefoot {

/// "hip, knee: 3 × 3 = 9"
std::string actionsOf(const Task& task);
void describeParts(const RobotSpec& spec, const Robot& robot, EnvironmentInspection& found);

/// What one looks at to see a fall: the height of the body that must not touch, or the state variable whose ending is
/// a fall.
struct Trace {
  std::string title{};
  int body = -1;  ///< or
  int state = 0;
};
Trace traceOf(const RobotSpec& spec);

}  // namespace surefoot
