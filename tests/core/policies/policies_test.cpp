// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

#include "core/policies/epsilon_greedy.h"
#include "core/policies/greedy.h"
#include "core/policies/mellowmax.h"
#include "core/policies/softmax.h"
#include "core/policies/threshold_restricted.h"

namespace surefoot {

namespace {

std::vector<double> probabilities(const Policy& policy, const std::vector<double>& q) {
  std::vector<double> pi(q.size());
  policy.probabilities({.q = q}, pi);
  return pi;
}

ThresholdRestricted trl(double threshold, double epsilon = 0.05, double below = 0.01) {
  return ThresholdRestricted({.exploration = {epsilon}, .threshold = threshold, .below = below});
}

}  // namespace

TEST(Greedy, SharesTheProbabilityAmongTies) {
  EXPECT_EQ(probabilities(Greedy(), {1, 3, 3, 2}), (std::vector<double>{0, 0.5, 0.5, 0}));
}

// (1 − 0.05)·greedy + 0.05/4, by hand.
TEST(EpsilonGreedy, IsGreedyButForEpsilon) {
  const auto pi = probabilities(EpsilonGreedy(), {1, 5, 2, 3});
  EXPECT_DOUBLE_EQ(pi[0], 0.0125);
  EXPECT_DOUBLE_EQ(pi[1], 0.9625);
  EXPECT_DOUBLE_EQ(pi[2], 0.0125);
}

// Thesis, Algorithm 1, by hand: A⁺ = {1, 2}; 0.95 to the best, 0.05·0.99/2 to each in A⁺, 0.05·0.01/3 to each outside.
TEST(ThresholdRestricted, ExploresAboveTheThreshold) {
  const auto pi = probabilities(trl(50), {10, 80, 60, 50, -20});
  EXPECT_DOUBLE_EQ(pi[1], 0.95 + 0.05 * 0.99 / 2);
  EXPECT_DOUBLE_EQ(pi[2], 0.05 * 0.99 / 2);
  for (const std::size_t a : {0u, 3u, 4u}) EXPECT_DOUBLE_EQ(pi[a], 0.05 * 0.01 / 3);  // 50 is not above 50
}

TEST(ThresholdRestricted, EqualsEpsilonGreedyAtBothInfinities) {
  const std::vector<double> q = {1.5, -2.0, 7.25, 7.25, 0.0};
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(probabilities(trl(infinity), q), probabilities(EpsilonGreedy(), q));
  EXPECT_EQ(probabilities(trl(-infinity), q), probabilities(EpsilonGreedy(), q));
}

// exp(1), exp(2), exp(3) over their sum.
TEST(Softmax, IsTheGibbsDistribution) {
  const auto pi = probabilities(Softmax({.temperature = 1.0}), {1, 2, 3});
  const double sum = std::exp(1.0) + std::exp(2.0) + std::exp(3.0);
  for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(pi[a], std::exp(1.0 + static_cast<double>(a)) / sum, 1e-15);
}

TEST(Softmax, IsRightAtATemperatureTheThesisCouldNotReach) {
  const auto pi = probabilities(Softmax({.temperature = 1e-3}), {100.0, 100.001, 99.0});
  EXPECT_NEAR(pi[1] / pi[0], std::exp(1.0), 1e-9);  // 100.001 − 100 carries a rounding of 1e-14, divided by τ
  EXPECT_EQ(pi[2], 0.0);
}

TEST(Softmax, IsRightForValuesOfAMillion) {
  const auto pi = probabilities(Softmax({.temperature = 1.0}), {1e6, -1e6, 1e6 - 1});
  EXPECT_EQ(pi[1], 0.0);
  EXPECT_NEAR(pi[2] / pi[0], std::exp(-1.0), 1e-15);
  const auto low = probabilities(Softmax({.temperature = 1.0}), {-1e6, -1e6});
  EXPECT_EQ(low, (std::vector<double>{0.5, 0.5}));
}

// Thesis, section 2.1: high τ nearly equiprobable, low τ nearly greedy.
TEST(Softmax, LimitsOfTheTemperature) {
  const std::vector<double> q = {10, 20, 5};
  for (const double p : probabilities(Softmax({.temperature = 1e6}), q)) EXPECT_NEAR(p, 1.0 / 3, 1e-5);
  EXPECT_EQ(probabilities(Softmax({.temperature = 1e-6}), q), (std::vector<double>{0, 1, 0}));
}

// With q = (0, 1) the expected value is π(1) itself, which is to be mm_ω = ln((1 + e^ω)/2)/ω.
TEST(Mellowmax, OfTwoActionsIsMellowmaxItself) {
  for (const double omega : {1e-3, 0.1, 1.0, 5.0, 50.0}) {
    const auto pi = probabilities(Mellowmax({omega}), {0.0, 1.0});
    EXPECT_NEAR(pi[1], std::log((1.0 + std::exp(omega)) / 2.0) / omega, 1e-9) << omega;
  }
}

// Asadi & Littman 2017, section 5: Σ π(a) q(a) = mm_ω(q), and π is a Softmax.
TEST(Mellowmax, HasMellowmaxAsItsMean) {
  const std::vector<double> q = {-100.0, -3.0, 0.5, 0.6, 42.0, 41.0};
  for (const double omega : {0.01, 0.3, 2.0}) {
    const auto pi = probabilities(Mellowmax({omega}), q);
    double sum = 0.0, mean = 0.0;
    for (std::size_t a = 0; a < q.size(); ++a) sum += std::exp(omega * (q[a] - 42.0)), mean += pi[a] * q[a];
    EXPECT_NEAR(mean, 42.0 + std::log(sum / 6.0) / omega, 1e-9) << omega;
    EXPECT_NEAR(std::log(pi[3] / pi[2]) / 0.1, std::log(pi[4] / pi[5]), 1e-6) << "one β for all";
  }
}

TEST(Mellowmax, LimitsAndLargeValues) {
  for (const double p : probabilities(Mellowmax({1.0}), {7.0, 7.0, 7.0})) EXPECT_EQ(p, 1.0 / 3.0);
  EXPECT_NEAR(probabilities(Mellowmax({1e6}), {1.0, 2.0, 3.0})[2], 1.0, 1e-5);
  EXPECT_NEAR(probabilities(Mellowmax({1e-6}), {1.0, 2.0, 3.0})[0], 1.0 / 3.0, 1e-5);
  double sum = 0.0;
  for (const double p : probabilities(Mellowmax({1.0}), {1e6, -1e6, 0.0, 1e6})) sum += p;
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(Sample, MatchesTheProbabilities) {
  const std::vector<double> pi = {0.1, 0.0, 0.65, 0.25};
  std::vector<int> counts(pi.size());
  Random random(11);
  constexpr int kDraws = 200'000;
  for (int i = 0; i < kDraws; ++i) ++counts[static_cast<std::size_t>(sample(pi, random))];
  EXPECT_EQ(counts[1], 0);
  for (std::size_t a = 0; a < pi.size(); ++a)  // five standard errors of a binomial share
    EXPECT_NEAR(counts[a] / static_cast<double>(kDraws), pi[a], 5 * std::sqrt(pi[a] * (1 - pi[a]) / kDraws));
}

TEST(Sample, ASumBelowOneFallsToTheLastPossibleAction) {
  const std::vector<double> pi = {0.0, 0.0, 1e-300, 0.0};
  Random random(5);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(sample(pi, random), 2);
}

}  // namespace surefoot
