// SPDX-License-Identifier: GPL-3.0-or-later
// Two learners taught by the same stream of transitions (thesis, section 6.1.2).
#pragma once

#include "core/experiment/configuration.h"

namespace surefoot {

/// The largest |q̂₁(s, a) − q̂₂(s, a)| over the actions of every tenth state that the first one's environment came
/// through, after so many steps of random actions.
Result<double> largestDifference(const Registry& registry, const Configuration& first, const Configuration& second,
                                 int steps);

}  // namespace surefoot
