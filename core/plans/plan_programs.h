// SPDX-License-Identifier: GPL-3.0-or-later
// Robots of a plan that programs move: nobody may have allowed these to start.
#pragma once

#include <memory>
#include <vector>

#include "core/plans/plan.h"
#include "core/registry.h"

namespace surefoot {

/// Those that are not allowed, in the order of the conditions. Any thread.
std::vector<std::shared_ptr<const EnvironmentFile>> programsToAllow(const Registry& registry, const Plan& plan);

/// Refuses the first of them: what it would start, where, and what that could do.
Status checkPrograms(const Registry& registry, const Plan& plan);

}  // namespace surefoot
