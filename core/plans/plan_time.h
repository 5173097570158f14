// SPDX-License-Identifier: GPL-3.0-or-later
// About how long a plan takes, told before it runs.
#pragma once

#include <optional>
#include <string>

#include "core/plans/plan_file.h"
#include "core/registry.h"

namespace surefoot {

/// Minutes on so many threads, from the lengths of lives and the measured speed of the environments (the handbook's
/// page "Speed"), without trying the plan out: right within a factor of about two. If a recipe has a measured time on
/// two cores (minutes_on_two_cores), it is used instead, scaled to another number of lives (from its
/// minutes_for_lives). `lives`: a condition, in place of the plan's.
double minutesFor(const Registry& registry, const PlanFile& plan, int threads, std::optional<int> lives = {});

/// "2 s", "4 min", "1 h 10 min"
std::string roundedTime(double minutes);

}  // namespace surefoot
