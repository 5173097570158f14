// SPDX-License-Identifier: GPL-3.0-or-later
// A walker's strides in a roll-out, as JSON and as lines of a table.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/signals/strides.h"

namespace surefoot {

/// How many there are, and mean and standard deviation of length, duration, speed, energy, energy a metre and the share
/// with both feet down; what is not known is null. Of no strides: null.
nlohmann::ordered_json asJson(const std::vector<Stride>& strides);
/// Lines like "stride length           0.53 ± 0.04 m"; of no strides: empty.
std::string asLines(const std::vector<Stride>& strides);

}  // namespace surefoot
