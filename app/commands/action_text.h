// SPDX-License-Identifier: GPL-3.0-or-later
// States and actions as people write them.
#pragma once

#include "core/environment.h"

namespace surefoot {

/// The values of the state variables from "0.1,0,0", each in its range.
Result<std::vector<double>> parseState(const std::string& option, const std::string& text, const Task& task);

/// The name of action `a`: "left", "0.75" for a torque, "-8.9 0 8.9" for three voltages.
std::string actionText(const Task& task, std::size_t a);

/// The same with the unit: "0.75 N m".
std::string actionWithUnit(const Task& task, std::size_t a);

}  // namespace surefoot
