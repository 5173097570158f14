// SPDX-License-Identifier: GPL-3.0-or-later
// sin and cos in single precision with the same bits on every processor. The C library picks one of several versions
// by what the processor can do, and one result in some ten millions differs between them by its last bit.
//
// Method: x = n·½π + r with abs(r) ≤ ¼π, in double precision, then a polynomial of degree 7 for sin r, of degree 8 for
// cos r (coefficients: Arm Optimized Routines, as in glibc since 2.28), every sum of a product rounded once (fused
// multiply-add, in software where the processor has none). These are the bits of glibc on processors that have it.
#pragma once

#include <cmath>

#include "core/basics/portable_math.h"

namespace surefoot {

/// sin(x + quarters·½π) to 0.56 units in the last place, for abs(x) < 120.
[[gnu::always_inline]] inline float singleSineTurned(float x, int quarters) {
  constexpr double kSin1 = -0x1.555545995a603p-3, kSin2 = 0x1.1107605230bc4p-7, kSin3 = -0x1.994eb3774cf24p-13;
  constexpr double kCos1 = -0x1.ffffffd0c621cp-2, kCos2 = 0x1.55553e1068f19p-5, kCos3 = -0x1.6c087e89a359dp-10,
                   kCos4 = 0x1.99343027bf8c3p-16;
  constexpr double kTwoOverPi = 0x1.45F306DC9C883p+23;  // times 2²⁴
  constexpr double kHalfPi = 0x1.921FB54442D18p0;
  constexpr float kQuarterPi = 0x1.921FB6p-1f;
  double r = static_cast<double>(x);
  int n = quarters;
  if (!(std::abs(x) < kQuarterPi)) {
    const int nearest = (static_cast<int>(r * kTwoOverPi) + 0x800000) >> 24;
    r = std::fma(-static_cast<double>(nearest), kHalfPi, r);
    n += nearest;
  }
  const double square = r * r;
  double value = 0.0;
  if ((n & 1) == 0) {
    const double cube = r * square;
    value = std::fma(cube * square, std::fma(square, kSin3, kSin2), std::fma(cube, kSin1, r));
  } else {
    const double fourth = square * square;
    const double low = std::fma(fourth, kCos2, std::fma(square, kCos1, 1.0));
    value = std::fma(fourth * square, std::fma(square, kCos4, kCos3), low);
  }
  return static_cast<float>((n & 2) != 0 ? -value : value);
}

/// The same for any x; what is no number, or infinite, gives no number.
[[gnu::always_inline]] inline float singleSineOfAny(float x, int quarters) {
  if (std::abs(x) < 120.0f) return singleSineTurned(x, quarters);
  if (!(std::abs(x) < 1e9f)) return x - x;
  return static_cast<float>(portableCosTurned(static_cast<double>(x), quarters + 3));
}

/// For processors with fused multiply-add, and for all.
float singleSineFused(float x, int quarters);
float singleSineAnywhere(float x, int quarters);
bool hasFusedMultiplyAdd();

}  // namespace surefoot
