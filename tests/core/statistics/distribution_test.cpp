// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/distribution.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/basics/random.h"

namespace surefoot {

namespace {

std::vector<double> countTo(int n) {
  std::vector<double> x(static_cast<std::size_t>(n));
  std::iota(x.begin(), x.end(), 1.0);
  return x;
}

}  // namespace

TEST(Distribution, TheInterquartileMeanCutsAQuarterAtEachEnd) {
  EXPECT_DOUBLE_EQ(interquartileMean(countTo(12)), 6.5);
  EXPECT_DOUBLE_EQ(interquartileMean(countTo(10)), 5.5) << "half of the third and of the eighth";
  auto wild = countTo(12);
  wild.back() = 1e6;
  EXPECT_DOUBLE_EQ(interquartileMean(wild), 6.5) << "an outlier does not matter";
  EXPECT_DOUBLE_EQ(interquartileMean(std::vector<double>{3}), 3);
  EXPECT_TRUE(std::isnan(interquartileMean({})));
}

TEST(Distribution, TheWorstAreTheLargest) {
  EXPECT_DOUBLE_EQ(worstMean(countTo(20), 0.1), 19.5);
  EXPECT_DOUBLE_EQ(worstMean(countTo(3), 0.1), 3) << "at least one";
}

// R: wilcox.test(extra ~ group, data = sleep): W = 25.5, the pairs of 100 in which the first drug gave more sleep.
TEST(Distribution, ImprovementIsMannAndWhitneysU) {
  const std::vector<double> first = {0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
  const std::vector<double> second = {1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};
  EXPECT_DOUBLE_EQ(improvement(first, second), 0.745);
  EXPECT_DOUBLE_EQ(improvement(second, first), 0.255);
  EXPECT_DOUBLE_EQ(improvement(first, first), 0.5);
}

TEST(Distribution, AFewUnitsHaveNoInterval) {
  EXPECT_FALSE(bootstrapped(countTo(7), Units::each(7), interquartileMean).known());
  const Interval i = bootstrapped(countTo(40), Units::each(40), interquartileMean);
  ASSERT_TRUE(i.known());
  EXPECT_LT(i.low, i.value);
  EXPECT_GT(i.high, i.value);
  // Forty lives of four Q-functions are four units.
  Units shared{.of = {}, .count = 4, .areQFunctions = true};
  for (std::size_t k = 0; k < 40; ++k) shared.of.push_back(k % 4);
  EXPECT_FALSE(bootstrapped(countTo(40), shared, interquartileMean).known());
}

// 1,000 experiments of 40 lives with Γ-like, skewed falls: the interval of the IQM holds the true one.
TEST(Distribution, IntervalsOfTheInterquartileMeanCoverIt) {
  Random random(3);
  const auto falls = [&] {
    double sum = 0;  // Erlang, shape 3, mean 24
    for (int k = 0; k < 3; ++k) sum -= 8 * std::log(1 - random.uniform());
    return sum;
  };
  std::vector<double> many(200'000);
  for (double& x : many) x = falls();
  const double truth = interquartileMean(many);
  int held = 0;
  constexpr int kExperimentsOfIqm = 300;
  for (int e = 0; e < kExperimentsOfIqm; ++e) {
    std::vector<double> lives(40);
    for (double& x : lives) x = falls();
    const Interval i = bootstrapped(lives, Units::each(lives.size()), interquartileMean);
    held += i.low <= truth && truth <= i.high;
  }
  EXPECT_NEAR(static_cast<double>(held) / kExperimentsOfIqm, 0.95, 0.04);
}

}  // namespace surefoot
