// SPDX-License-Identifier: GPL-3.0-or-later
// What the curve of a life is called: by what the life did, not by what is chosen now.
#pragma once

#include <string>

#include "core/registry.h"
#include "ui/session/run_curves.h"

namespace surefoot {

/// "ε-greedy → Softmax, Sarsa": the policies that episodes were lived under, in their order, and the learning rule;
/// then how the life began, unless it began empty: "TRL, Sarsa, pre-learned (scenario 2)". Of more than three policies
/// the first and the last are named. Titles are those of the registry; a name that it does not know stands as it is.
std::string nameOf(const RunCurve& curve, const Registry& registry);
/// The policies alone: "ε-greedy → Softmax".
std::string policiesOf(const RunCurve& curve, const Registry& registry);

}  // namespace surefoot
