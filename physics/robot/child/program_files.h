// SPDX-License-Identifier: GPL-3.0-or-later
// What the program of a robot is: its command, its folder, and what the files of the command hold. Any thread.
#pragma once

#include <cstdint>
#include <string>

#include "physics/robot/spec/robot_spec.h"

namespace surefoot {

/// Of the files that a robot's command names and that lie in its folder.
std::uint64_t printOfFiles(const RobotSpec& spec, const std::string& folder);

/// As EnvironmentPrograms takes it (EnvironmentFile::program): another one as soon as anything of it is.
std::string programOf(const RobotSpec& spec, const std::string& folder);

/// "python3 hopper.py"
std::string commandText(const RobotSpec& spec);

}  // namespace surefoot
