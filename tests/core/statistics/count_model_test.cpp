// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/count_model.h"

#include <gtest/gtest.h>

namespace surefoot {

// Without scatter beyond Poisson and without shared units the ratio is that of the means, and its interval that of two
// Poisson numbers: exp(log r ± 1.96 √(1/Σa + 1/Σb)) to a few per cent.
TEST(CountModel, OfPoissonNumbersIsTheirRatio) {
  const std::vector<double> a = {9, 12, 10, 11, 8, 10, 13, 7, 11, 9}, b = {5, 4, 6, 5, 5, 3, 7, 5, 4, 6};
  const auto r = countRatio(a, Units::each(10), b, Units::each(10), false);
  ASSERT_TRUE(r);
  EXPECT_NEAR(r->ratio.value, 0.5, 1e-3);
  const double error = std::sqrt(1.0 / 100 + 1.0 / 50);
  EXPECT_NEAR(r->ratio.low, 0.5 * std::exp(-1.96 * error), 0.01);
  EXPECT_NEAR(r->ratio.high, 0.5 * std::exp(1.96 * error), 0.02);
  EXPECT_LT(r->dispersion, 0.01);
  EXPECT_LT(r->p, 1e-4);
}

// No fall in ten lives after ten lives with 20 falls: the likelihood drops by 1.92 where 10·μ·ratio = 1.92, so the
// ratio is below 0.096.
TEST(CountModel, TellsHowRareFallsMayBeWhereThereWereNone) {
  const std::vector<double> a(10, 2.0), b(10, 0.0);
  const auto r = countRatio(a, Units::each(10), b, Units::each(10), false);
  ASSERT_TRUE(r);
  EXPECT_EQ(r->ratio.value, 0);
  EXPECT_EQ(r->ratio.low, 0);
  EXPECT_NEAR(r->ratio.high, 0.096, 0.012);
  EXPECT_LT(r->p, 1e-5);
}

// Q-functions whose lives fall 4 to 64 times: pairs see the half beneath that scatter, two separate groups do not.
TEST(CountModel, AQFunctionIsARandomEffect) {
  std::vector<double> a, b;
  for (int q = 0; q < 12; ++q) {
    const double mean = std::pow(2, 2 + 4 * q / 11.0);
    a.push_back(std::round(mean + (q % 3 - 1))), b.push_back(std::round(mean / 2 + (q % 2)));
  }
  const auto pairs = countRatio(a, Units::each(12), b, Units::each(12), true);
  const auto apart = countRatio(a, Units::each(12), b, Units::each(12), false);
  ASSERT_TRUE(pairs && apart);
  EXPECT_LT(pairs->p, 1e-5);
  EXPECT_GT(apart->p, 0.02);
  EXPECT_NEAR(pairs->deviation, 0.83, 0.25) << "the deviation of the logarithms of the means";
  EXPECT_NEAR(pairs->ratio.value, 0.53, 0.06);
  EXPECT_LT(pairs->ratio.high - pairs->ratio.low, (apart->ratio.high - apart->ratio.low) / 2);
}

TEST(CountModel, WhatIsNoCountHasNone) {
  const std::vector<double> counts = {3, 4, 5}, halves = {0.5, 1, 2}, none = {0, 0, 0}, few = {1, 2};
  const auto of = [&](const std::vector<double>& a, const std::vector<double>& b) {
    return countRatio(a, Units::each(a.size()), b, Units::each(b.size()), false).has_value();
  };
  EXPECT_TRUE(of(counts, counts));
  EXPECT_FALSE(of(halves, counts));
  EXPECT_FALSE(of(counts, halves));
  EXPECT_FALSE(of(none, counts));
  EXPECT_FALSE(of(few, counts));
}

}  // namespace surefoot
