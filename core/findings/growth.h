// SPDX-License-Identifier: GPL-3.0-or-later
// How many lives a plan that grows (plan_growth.h) wants next, and what it has found: from the results alone, so that
// the same plan and seed end at the same place, however often they were stopped, and on any number of threads.
#pragma once

#include "core/findings/evidence.h"
#include "core/plans/plan_growth.h"

namespace surefoot {

enum class Decision { Open, Fewer, More, Equivalent };

/// A condition against its reference, at a level of error: different by testOfUnits, or the same because the
/// (1 − 2·level) interval of the change lies within ± `widest` per cent (two one-sided tests; Schuirmann 1987).
Decision decide(const Evidence& reference, const Evidence& e, std::string_view measure, double level, double widest);

struct GrowthState {
  std::vector<int> lives;              ///< wanted, a condition; more than there are: live them and ask again
  std::vector<std::string> sentences;  ///< what was found, once nothing more is wanted
};

/// `evidence`: of all conditions of the plan, in order.
GrowthState growthOf(const PlanGrowth& growth, const std::vector<Evidence>& evidence);

}  // namespace surefoot
