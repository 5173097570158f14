// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a robot's file (surefoot = "robot 1", TOML 1.0). Any thread.
#pragma once

#include <memory>

#include "physics/robot/spec/robot_spec.h"

namespace surefoot {

inline constexpr std::size_t kLongestRobot = 256u << 10;  ///< [bytes]
inline constexpr std::size_t kMostComplaints = 20;

/// The robot; nothing if there is any complaint. Complaints stand in the order of the file, at most kMostComplaints.
/// What depends on the values of parameters (a mass that becomes negative) is not looked at: see checkRobot().
std::shared_ptr<const RobotSpec> readRobot(std::string_view text, std::vector<Complaint>& complaints);

}  // namespace surefoot
