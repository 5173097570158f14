// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/round_numbers.h"

#include <algorithm>
#include <cmath>

namespace surefoot {

double niceAbove(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-9))));
  for (const double m : {1.0, 2.0, 5.0})
    if (m * power >= value) return m * power;
  return 10.0 * power;
}

}  // namespace surefoot
