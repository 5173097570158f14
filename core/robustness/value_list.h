// SPDX-License-Identifier: GPL-3.0-or-later
// The values along one side of a grid, as a person types them: a list, "0;0.5;1" (core/text/number_text.h), or so many
// values at equal distances, "0..2:9" (both ends belong to it). Any thread.
#pragma once

#include <string_view>
#include <vector>

#include "core/parameters.h"

namespace surefoot {

inline constexpr std::size_t kMostValues = 1000;

/// 1 to kMostValues values, each allowed for the parameter, none twice. Values of a range are rounded to 12 digits, so
/// that they read as if they were typed.
Result<std::vector<double>> parseValues(const Parameter& parameter, std::string_view text);

/// "0..5" or "2", which is 2..2: two numbers, the first not above the second.
Result<std::pair<double, double>> parseSpan(std::string_view name, std::string_view text);

}  // namespace surefoot
