// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/expression/range.h"

namespace surefoot {

namespace {

constexpr Range kTruth{0.0, 1.0};

/// 1 if it holds for all values, 0 if for none.
Range truth(bool always, bool never) {
  return always ? Range{1.0, 1.0} : never ? Range{0.0, 0.0} : kTruth;
}

Range productOf(Range a, Range b) {
  Range r{kInfinity, -kInfinity};
  for (const double x : {a.low, a.high})
    for (const double y : {b.low, b.high}) {
      const double product = x == 0.0 || y == 0.0 ? 0.0 : x * y;  // infinity itself is no value
      r = together(r, {product, product});
    }
  return r;
}

Range absOf(Range x) {
  const double most = std::max(std::abs(x.low), std::abs(x.high));
  return {x.low <= 0.0 && x.high >= 0.0 ? 0.0 : std::min(std::abs(x.low), std::abs(x.high)), most};
}

}  // namespace

Range rangeOf(Operation operation, Range x) {
  switch (operation) {
    case Operation::Minus:
      return {-x.high, -x.low};
    case Operation::Not:
      return truth(x.low == 0.0 && x.high == 0.0, x.low > 0.0 || x.high < 0.0);
    case Operation::Abs:
      return absOf(x);
    case Operation::Sign:
    case Operation::Sin:
    case Operation::Cos:
      return {-1.0, 1.0};
    case Operation::Floor:
      return {std::floor(x.low), std::floor(x.high)};
    case Operation::Round:
      return {std::round(x.low), std::round(x.high)};
    case Operation::Exp:
      return {0.0, kInfinity};
    case Operation::Square:
      return productOf(absOf(x), absOf(x));
    default:
      return {};
  }
}

Range rangeOf(Operation operation, Range a, Range b) {
  const bool apart = a.high < b.low || b.high < a.low, same = a.low == a.high && b.low == b.high && a.low == b.low;
  switch (operation) {
    case Operation::Add:
      return {a.low + b.low, a.high + b.high};
    case Operation::Subtract:
      return {a.low - b.high, a.high - b.low};
    case Operation::Multiply:
      return productOf(a, b);
    case Operation::Less:
      return truth(a.high < b.low, a.low >= b.high);
    case Operation::LessOrEqual:
      return truth(a.high <= b.low, a.low > b.high);
    case Operation::Greater:
      return truth(a.low > b.high, a.high <= b.low);
    case Operation::GreaterOrEqual:
      return truth(a.low >= b.high, a.high < b.low);
    case Operation::Equal:
      return truth(same, apart);
    case Operation::NotEqual:
      return truth(apart, same);
    case Operation::Min:
      return {std::min(a.low, b.low), std::min(a.high, b.high)};
    case Operation::Max:
      return {std::max(a.low, b.low), std::max(a.high, b.high)};
    case Operation::Hypot:
      return {0.0, kInfinity};
    default:
      return {};
  }
}

}  // namespace surefoot
