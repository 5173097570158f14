// SPDX-License-Identifier: GPL-3.0-or-later
// How the numbers of a table or a report are written.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/statistics/statistics.h"

namespace surefoot {

/// "−45.0 (−55.1 … −32.0)"; without an interval the number alone, and nothing for NaN.
std::string changeText(const Interval& change, int decimals);

/// Digits behind the point with which a number has about three: 0 from 100 on, 1 from 10 on, else 2.
int decimalsOf(double value);
/// "93.4 ± 4.1"; without an interval the value alone; "–" where there is no value.
std::string plusMinusText(const Interval& interval, int decimals);
/// "+4.1", "-45.0", "0.0": a value that rounds to 0 has no sign.
std::string signedText(double value, int decimals);
/// A cell of a table for other programs, with `digits` digits; empty if the value is not finite.
std::string numberCell(double value, int digits);
/// The value; null if it is not finite.
nlohmann::ordered_json numberAsJson(double value);
/// "0.0031", "< 1e-10"; "–" for NaN: no test
std::string shortPText(double p);

}  // namespace surefoot
