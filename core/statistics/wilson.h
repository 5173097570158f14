// SPDX-License-Identifier: GPL-3.0-or-later
// The share of trials that ended in a certain way, with Wilson's score interval (1927; Agresti & Coull 1998): of k in n
// trials, p = k/n and z = 1.96,
//   (p + z²/2n ± z √(p(1 − p)/n + z²/4n²)) / (1 + z²/n).
// It stays within 0 … 1, and it has a width where no trial or every trial ended so. Any thread.
#pragma once

#include <cstdint>

#include "core/statistics/statistics.h"

namespace surefoot {

/// 95 %; NaN where there is no trial. 0 ≤ count ≤ trials.
Interval wilsonInterval(std::int64_t count, std::int64_t trials);

}  // namespace surefoot
