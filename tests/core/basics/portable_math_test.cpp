// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/basics/portable_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace surefoot {

// Both functions round once or twice, so they may differ in the last two binary places.
TEST(PortableExp, AgreesWithTheLibraryToTwoUnitsInTheLastPlace) {
  for (double x = -708.0; x <= 709.0; x += 0.0317) {
    const double expected = std::exp(x);
    EXPECT_NEAR(portableExp(x) / expected, 1.0, 2 * std::numeric_limits<double>::epsilon()) << x;
  }
}

TEST(PortableExp, IsExactAtZeroAndMeetsItsLimits) {
  EXPECT_EQ(portableExp(0.0), 1.0);
  EXPECT_EQ(portableExp(-1e12), 0.0);
  EXPECT_EQ(portableExp(-std::numeric_limits<double>::infinity()), 0.0);
  EXPECT_EQ(portableExp(1e12), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(portableExp(std::nan(""))));
  EXPECT_GT(portableExp(709.78), 1e308);
}

TEST(PortableLog, AgreesWithTheLibrary) {
  for (double x = 1e-320; x < 1e308; x *= 1.37)
    EXPECT_NEAR(portableLog(x), std::log(x), 3e-16 * std::max(1.0, std::abs(std::log(x)))) << x;
  for (double x = 0.5; x < 2.0; x += 0.00137)
    EXPECT_NEAR(portableLog(x), std::log(x), 3e-16 * std::abs(std::log(x)) + 1e-17) << x;
  EXPECT_EQ(portableLog(1.0), 0.0);
}

TEST(PortableCos, AgreesWithTheLibrary) {
  for (double x = -50.0; x <= 50.0; x += 0.0137) EXPECT_NEAR(portableCos(x), std::cos(x), 4e-16) << x;
  EXPECT_EQ(portableCos(0.0), 1.0);
}

TEST(PortableSin, AgreesWithTheLibraryAlsoNearZero) {
  for (double x = -50.0; x <= 50.0; x += 0.0137) EXPECT_NEAR(portableSin(x), std::sin(x), 4e-16) << x;
  for (double x = 1e-300; x < 0.1; x *= 3.7) {
    EXPECT_NEAR(portableSin(x) / std::sin(x), 1.0, 2 * std::numeric_limits<double>::epsilon()) << x;
    EXPECT_EQ(portableSin(-x), -portableSin(x));
  }
  EXPECT_EQ(portableSin(0.0), 0.0);
}

// Subnormal numbers have no more than an absolute precision of 2^-1074.
TEST(PortableExp, UnderflowsGradually) {
  for (double x = -745.0; x < -708.0; x += 0.37)
    EXPECT_NEAR(portableExp(x) * 0x1p1000, std::exp(x) * 0x1p1000, 0x1p-73 + 1e-15 * std::exp(x) * 0x1p1000) << x;
}

}  // namespace surefoot
