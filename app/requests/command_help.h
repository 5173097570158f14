// SPDX-License-Identifier: GPL-3.0-or-later
// The commands as the handbook tells of them.
#pragma once

#include "core/handbook/handbook.h"

namespace surefoot {

/// Every command with its options and examples, in the order of `surefoot --help`.
std::vector<CommandHelp> commandHelp(const Registry& registry);

}  // namespace surefoot
