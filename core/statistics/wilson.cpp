// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/wilson.h"

#include <algorithm>

namespace surefoot {

Interval wilsonInterval(std::int64_t count, std::int64_t trials) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (trials <= 0) return {kNone, kNone, kNone};
  constexpr double z = 1.959963984540054;  // the normal distribution's 0.975-quantile
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(count) / n;
  const double middle = (p + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n)) / (1 + z * z / n);
  // Rounding must not leave 0 or 1 outside.
  return {p, count == 0 ? 0.0 : std::max(0.0, middle - half), count == trials ? 1.0 : std::min(1.0, middle + half)};
}

}  // namespace surefoot
