// SPDX-License-Identifier: GPL-3.0-or-later
// Two lives held against each other where they are comparable: at the same number of episodes, and at the same
// simulated time. The counters of lives of unequal length say nothing.
#pragma once

#include <cstdint>
#include <optional>

#include "ui/session/run_curves.h"

namespace surefoot {

struct ComparedFalls {
  std::int64_t at = 0;  ///< episodes, or steps of the life
  std::int64_t first = 0, second = 0;
};

/// The falls of both when each had lived as many episodes as the shorter one has; nothing before both have one.
std::optional<ComparedFalls> fallsAtEqualEpisodes(const RunCurve& first, const RunCurve& second);
/// The same at equal steps of the life, and so at equal simulated time.
std::optional<ComparedFalls> fallsAtEqualSteps(const RunCurve& first, const RunCurve& second);

}  // namespace surefoot
