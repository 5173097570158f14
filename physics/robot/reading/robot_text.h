// SPDX-License-Identifier: GPL-3.0-or-later
// Changes in a robot's text that leave all else of it as it is: comments, spaces, order.
#pragma once

#include <string>
#include <string_view>

namespace surefoot {

/// Why this cannot be a robot's name; null: it can.
std::string wrongRobotName(std::string_view name);

/// The same robot under another name, with a title from it.
std::string renamedRobot(std::string_view text, std::string_view name);

}  // namespace surefoot
