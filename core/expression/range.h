// SPDX-License-Identifier: GPL-3.0-or-later
// The values that an expression can have at most, from those of its parts: what can never hold is told when it is read.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/basics/types.h"
#include "core/expression/expression.h"

namespace surefoot {

struct Range {
  double low = -kInfinity, high = kInfinity;

  bool empty() const { return !(low <= high); }
};

inline Range together(Range a, Range b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

/// Of an operation of one value, or of two; everything where little is known.
Range rangeOf(Operation operation, Range x);
Range rangeOf(Operation operation, Range a, Range b);

}  // namespace surefoot
