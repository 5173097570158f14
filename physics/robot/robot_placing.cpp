// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/robot.h"

namespace surefoot {

bool Robot::place(std::span<const double>) {
  return false;
}

std::vector<double> Robot::poseAt(std::span<const double>) const {
  return {};
}

}  // namespace surefoot
