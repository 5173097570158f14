// SPDX-License-Identifier: GPL-3.0-or-later
// exp, log, cos and sin with the same bits on every machine. The C library's own differs between processors with and
// without fused multiply-add, and one differing bit in a probability sends two lives apart.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace surefoot {

/// eˣ to about 1 unit in the last place, from additions and multiplications only (compiled with -ffp-contract=off).
/// Method: x = k·ln 2 + r with abs(r) ≤ ½ ln 2, the Taylor polynomial of degree 13 for eʳ (remainder < 5e-18), times
/// 2ᵏ. Under- and overflow give 0 and infinity; NaN gives NaN.
inline double portableExp(double x) {
  constexpr double kLog2e = 1.4426950408889634074;
  constexpr double kLn2High = 6.93147180369123816490e-01;  // 33 bits, so that k·kLn2High is exact
  constexpr double kLn2Low = 1.90821492927058770002e-10;
  if (x != x) return x;
  if (x > 709.782712893384) return std::numeric_limits<double>::infinity();
  if (x < -745.2) return 0.0;
  const auto k = static_cast<std::int64_t>(x * kLog2e + (x < 0.0 ? -0.5 : 0.5));
  const auto kReal = static_cast<double>(k);
  const double r = (x - kReal * kLn2High) - kReal * kLn2Low;

  constexpr double kInverseFactorial[] = {1.0 / 6227020800.0,
                                          1.0 / 479001600.0,
                                          1.0 / 39916800.0,
                                          1.0 / 3628800.0,
                                          1.0 / 362880.0,
                                          1.0 / 40320.0,
                                          1.0 / 5040.0,
                                          1.0 / 720.0,
                                          1.0 / 120.0,
                                          1.0 / 24.0,
                                          1.0 / 6.0,
                                          0.5,
                                          1.0,
                                          1.0};
  double sum = 0.0;
  for (const double c : kInverseFactorial) sum = sum * r + c;

  const auto powerOfTwo = [](std::int64_t e) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
  };
  if (k > 1023) return sum * powerOfTwo(1023) * powerOfTwo(k - 1023);
  if (k < -1022) return sum * powerOfTwo(-1000) * powerOfTwo(k + 1000);  // subnormal results are rounded once
  return sum * powerOfTwo(k);
}

/// ln x for finite x > 0, to about 2 units in the last place. Method: x = m·2ᵏ with m from √½ to √2, and with
/// s = (m − 1)/(m + 1), below 0.172, ln m = 2 (s + s³/3 + s⁵/5 + …) up to s²¹ (remainder < 1e-18).
inline double portableLog(double x) {
  constexpr double kLn2High = 6.93147180369123816490e-01, kLn2Low = 1.90821492927058770002e-10;
  constexpr double kSqrt2 = 1.41421356237309504880, kTwoTo54 = 18014398509481984.0;
  std::int64_t k = -1023;
  if (x < std::numeric_limits<double>::min()) x *= kTwoTo54, k -= 54;  // subnormal
  const auto bits = std::bit_cast<std::uint64_t>(x);
  k += static_cast<std::int64_t>(bits >> 52);
  double m = std::bit_cast<double>((bits & ((std::uint64_t{1} << 52) - 1)) | (std::uint64_t{1023} << 52));
  if (m > kSqrt2) m *= 0.5, ++k;
  const double s = (m - 1.0) / (m + 1.0), square = s * s;
  double sum = 0.0;
  for (int n = 21; n >= 3; n -= 2) sum = (sum + 1.0 / n) * square;
  const auto kReal = static_cast<double>(k);
  return kReal * kLn2High + (kReal * kLn2Low + 2.0 * (s + s * sum));
}

/// cos(x + quarters·½π) for abs(x) up to a thousand or so, to about 1e-15; beyond that it is less exact, and from 1e9
/// on no number. Method: x reduced by multiples of ½π in two pieces, then the Taylor polynomials of degree 16 and 17 on
/// ± ¼π (remainder < 1e-18). Near a zero at x = 0 the relative error is as small, because the first piece is x itself.
inline double portableCosTurned(double x, std::int64_t quarters) {
  constexpr double kTwoOverPi = 0.63661977236758134308;
  constexpr double kHalfPiHigh = 1.57079632673412561417e+00;  // 33 bits, so that k·kHalfPiHigh is exact
  constexpr double kHalfPiLow = 6.07710050650619224932e-11;
  if (!(x > -1e9 && x < 1e9)) return std::numeric_limits<double>::quiet_NaN();
  const auto k = static_cast<std::int64_t>(x * kTwoOverPi + (x < 0.0 ? -0.5 : 0.5));
  const auto kReal = static_cast<double>(k);
  const double r = (x - kReal * kHalfPiHigh) - kReal * kHalfPiLow;
  const double square = r * r;
  const std::int64_t quadrant = (k + quarters) & 3;
  const bool sine = (quadrant & 1) != 0;  // cos(r + ½π) = −sin r
  double term = sine ? r : 1.0, sum = term;
  for (int n = sine ? 3 : 2; n <= 17; n += 2) {
    term *= -square / (n * (n - 1));
    sum += term;
  }
  return quadrant == 1 || quadrant == 2 ? -sum : sum;
}

inline double portableCos(double x) {
  return portableCosTurned(x, 0);
}
inline double portableSin(double x) {
  return portableCosTurned(x, 3);
}

}  // namespace surefoot
