// SPDX-License-Identifier: GPL-3.0-or-later
// How the numbers of a table or a report are written.
#pragma once

#include <string>

#include "core/laboratory/statistics.h"

namespace surefoot {

/// Digits behind the point with which a number has about three: 0 from 100 on, 1 from 10 on, else 2.
int decimalsOf(double value);
/// "93.4 ± 4.1"; without an interval the value alone; "–" where there is no value.
std::string plusMinusText(const Interval& interval, int decimals);
/// "0.0031", "< 1e-10"; "–" of NaN: no test
std::string shortPText(double p);

}  // namespace surefoot
