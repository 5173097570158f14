// SPDX-License-Identifier: GPL-3.0-or-later
// The name of a life's curve: it tells how the life was lived, not what is chosen now.
#pragma once

#include <string>

#include "core/registry.h"
#include "ui/running/run_curves.h"

namespace surefoot {

/// "ε-greedy → Softmax, Sarsa": the policies that episodes were lived under, in their order, and the learning rule;
/// then how the life began, unless it began empty: "TRL, Sarsa, pre-learned (scenario 2)". With more than three
/// policies only the first and the last are named. Titles come from the registry; a name without one is not changed.
std::string nameOf(const RunCurve& curve, const Registry& registry);
/// The policies alone: "ε-greedy → Softmax".
std::string policiesOf(const RunCurve& curve, const Registry& registry);

}  // namespace surefoot
