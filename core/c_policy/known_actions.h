// SPDX-License-Identifier: GPL-3.0-or-later
// States with their actions, for the check inside a policy as C.
#pragma once

#include "core/action_value.h"
#include "core/c_policy/c_policy.h"

namespace surefoot {

/// A thousand states anywhere in the ranges of their variables in which one action is clearly the best, so that tables
/// of float have the same one; the same for the same values. Fewer where there are few.
std::vector<KnownAction> knownActions(const ActionValueFunction& values, const Task& task);

}  // namespace surefoot
