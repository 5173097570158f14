// SPDX-License-Identifier: GPL-3.0-or-later
// Compares two lives fairly: at the same number of episodes, and at the same simulated time. The counters of lives of
// unequal length cannot be compared.
#pragma once

#include <cstdint>
#include <optional>

#include "ui/running/run_curves.h"

namespace surefoot {

struct ComparedFalls {
  std::int64_t at = 0;  ///< episodes, or steps of the life
  std::int64_t first = 0, second = 0;
};

/// The falls of both after as many episodes as the shorter life has; nothing before both have one episode.
std::optional<ComparedFalls> fallsAtEqualEpisodes(const RunCurve& first, const RunCurve& second);
/// The same at equal steps of the life, and so at equal simulated time.
std::optional<ComparedFalls> fallsAtEqualSteps(const RunCurve& first, const RunCurve& second);

}  // namespace surefoot
