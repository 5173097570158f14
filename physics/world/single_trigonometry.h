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

/// An angle as quarter turns and a rest of at most half of one to either side.
struct QuarterTurns {
  int turns;
  double rest;
};

/// For abs(x) < 120.
[[gnu::always_inline]] inline QuarterTurns quarterTurnsOf(float x) {
  constexpr double kTwoOverPi = 0x1.45F306DC9C883p+23;  // times 2²⁴
  constexpr double kHalfPi = 0x1.921FB54442D18p0;
  constexpr float kQuarterPi = 0x1.921FB6p-1f;
  const auto full = static_cast<double>(x);
  if (std::abs(x) < kQuarterPi) return {0, full};
  const int nearest = (static_cast<int>(full * kTwoOverPi) + 0x800000) >> 24;
  return {nearest, std::fma(-static_cast<double>(nearest), kHalfPi, full)};
}

/// sin r and cos r for abs(r) ≤ ¼π, to 0.56 units in the last place.
[[gnu::always_inline]] inline void sineAndCosineOfRest(double r, float& sine, float& cosine) {
  constexpr double kSin1 = -0x1.555545995a603p-3, kSin2 = 0x1.1107605230bc4p-7, kSin3 = -0x1.994eb3774cf24p-13;
  constexpr double kCos1 = -0x1.ffffffd0c621cp-2, kCos2 = 0x1.55553e1068f19p-5, kCos3 = -0x1.6c087e89a359dp-10,
                   kCos4 = 0x1.99343027bf8c3p-16;
  const double square = r * r, cube = r * square, fourth = square * square;
  sine = static_cast<float>(std::fma(cube * square, std::fma(square, kSin3, kSin2), std::fma(cube, kSin1, r)));
  const double low = std::fma(fourth, kCos2, std::fma(square, kCos1, 1.0));
  cosine = static_cast<float>(std::fma(fourth * square, std::fma(square, kCos4, kCos3), low));
}

/// For any x; what is no number, or infinite, gives no number.
[[gnu::always_inline]] inline void sineAndCosineOf(float x, float& sine, float& cosine) {
  if (std::abs(x) < 120.0f) {
    const QuarterTurns q = quarterTurnsOf(x);
    sineAndCosineOfRest(q.rest, sine, cosine);
    if (q.turns == 0) return;
    const float s = sine, c = cosine;
    const bool odd = (q.turns & 1) != 0;
    sine = ((q.turns & 2) != 0 ? -1.0f : 1.0f) * (odd ? c : s);
    cosine = ((q.turns + 1) & 2) != 0 ? -(odd ? s : c) : (odd ? s : c);
  } else if (std::abs(x) < 1e9f) {
    sine = static_cast<float>(portableSin(static_cast<double>(x)));
    cosine = static_cast<float>(portableCos(static_cast<double>(x)));
  } else {
    sine = cosine = x - x;
  }
}

/// For processors with fused multiply-add, and for all.
void sineAndCosineFused(float x, float* sine, float* cosine);
void sineAndCosineAnywhere(float x, float* sine, float* cosine);
bool hasFusedMultiplyAdd();

}  // namespace surefoot
