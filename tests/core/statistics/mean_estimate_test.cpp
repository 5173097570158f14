// SPDX-License-Identifier: GPL-3.0-or-later
// By hand, and against Student's and Welch's intervals, which statistics_test holds against published ones.
#include "core/statistics/mean_estimate.h"

#include <gtest/gtest.h>

namespace surefoot {

namespace {

const std::vector<double> kA = {4, 6, 7, 9, 14}, kB = {1, 2, 4, 4, 9};

MeanEstimate alone(const std::vector<double>& values) {
  return estimateOf(values, Units::each(values.size()));
}
Units byTwo(std::size_t values) {
  Units units{.of = {}, .count = values / 2};
  for (std::size_t i = 0; i < values; ++i) units.of.push_back(i / 2);
  return units;
}

}  // namespace

TEST(MeanEstimate, OfIndependentLivesIsStudents) {
  const Interval ours = intervalOf(alone(kA)), students = *meanInterval(kA);
  EXPECT_NEAR(ours.low, students.low, 1e-12);
  EXPECT_NEAR(ours.high, students.high, 1e-12);
}

TEST(MeanEstimate, DifferenceOfIndependentLivesIsWelchs) {
  const Interval ours = differenceOf(alone(kA), alone(kB), false), welchs = *differenceInterval(kA, kB);
  EXPECT_NEAR(ours.value, -4, 1e-12);
  EXPECT_NEAR(ours.low, welchs.low, 1e-9);
  EXPECT_NEAR(ours.high, welchs.high, 1e-9);
}

TEST(MeanEstimate, OneLifeHasNoInterval) {
  const MeanEstimate one = alone({7}), none = alone({}), more = alone(kA);
  EXPECT_EQ(intervalOf(one).value, 7);
  EXPECT_FALSE(intervalOf(one).known());
  EXPECT_TRUE(std::isnan(intervalOf(none).value));
  for (const auto& [a, b] : {std::pair{one, more}, {more, one}, {one, one}}) {
    EXPECT_FALSE(differenceOf(a, b, false).known());
    EXPECT_FALSE(changeOf(a, b, false).known());
    EXPECT_TRUE(std::isfinite(changeOf(a, b, false).value));
  }
  Random random(1);
  EXPECT_TRUE(drawMeans(
                  {one, more}, {0, 1}, [](const auto& m) { return m[0]; }, random)
                  .empty());
}

TEST(MeanEstimate, LivesOfOneQFunctionAreOneUnit) {
  // Nothing varies but the Q-function: the interval is that of the three values.
  const std::vector<double> values = {10, 10, 12, 12, 17, 17}, three = {10, 12, 17};
  const Interval ours = intervalOf(estimateOf(values, byTwo(6)));
  EXPECT_NEAR(ours.low, meanInterval(three)->low, 1e-12);
  EXPECT_NEAR(ours.high, meanInterval(three)->high, 1e-12);
}

TEST(MeanEstimate, PairsThatDifferByOneHaveADifferenceOfOne) {
  std::vector<double> after = kA;
  for (double& v : after) ++v;
  const Interval paired = differenceOf(alone(kA), alone(after), true);
  EXPECT_NEAR(paired.low, 1, 1e-12);
  EXPECT_NEAR(paired.high, 1, 1e-12);
  EXPECT_GT(differenceOf(alone(kA), alone(after), false).high, 2);
}

TEST(MeanEstimate, PairsInProportionHaveAChangeOfNoWidth) {
  std::vector<double> half = kA;
  for (double& v : half) v /= 2;
  const Interval paired = changeOf(alone(kA), alone(half), true);
  EXPECT_NEAR(paired.low, -50, 1e-9);
  EXPECT_NEAR(paired.high, -50, 1e-9);
}

TEST(MeanEstimate, AChangeOfNothingIsNone) {
  const MeanEstimate zero = alone({0, 0, 0, 0}), some = alone(kA);
  EXPECT_TRUE(std::isnan(changeOf(zero, some, false).value));
  EXPECT_TRUE(std::isnan(changeOf(zero, zero, false).value));
  EXPECT_NEAR(differenceOf(zero, some, false).low, meanInterval(kA)->low, 1e-9);
  const Interval gone = changeOf(some, zero, false);  // nobody fell; that nobody would is not known
  EXPECT_EQ(gone.value, -100);
  EXPECT_FALSE(gone.known());
}

TEST(MeanEstimate, TwoOrThreeThatHappenToBeEqualDoNotSayHowTheyScatter) {
  EXPECT_FALSE(intervalOf(alone({17, 17, 17})).known());
  EXPECT_TRUE(intervalOf(alone({17, 17, 18})).known());
  EXPECT_EQ(intervalOf(alone({17, 17, 17, 17})).high, 17);
}

TEST(MeanEstimate, TwoOrThreePairsThatDifferByTheSameDoNotSayHowDifferencesScatter) {
  const MeanEstimate before = alone({10, 12}), after = alone({9, 11}), half = alone({5, 6});
  EXPECT_FALSE(differenceOf(before, after, true).known()) << "else it were −1 (−1 … −1)";
  EXPECT_TRUE(differenceOf(before, after, false).known());
  EXPECT_TRUE(changeOf(before, after, true).known());
  EXPECT_FALSE(changeOf(before, half, true).known()) << "each is half: no interval but for rounding";
  EXPECT_FALSE(differenceOf(alone({1, 2, 4}), alone({2, 3, 5}), true).known());
  EXPECT_TRUE(differenceOf(alone({1, 2, 4}), alone({2, 3, 6}), true).known());
  Random random(1);
  const auto rises = [](const std::vector<double>& m) { return m[1] < m[0] ? 1.0 : 0.0; };
  EXPECT_TRUE(drawMeans({before, after}, {0, 0}, rises, random).empty()) << "else they always fall";
}

TEST(MeanEstimate, FallsNeverChangeByLessThanAllOfThem) {
  const Interval i = changeOf(alone({2, 9, 4}), alone({0, 1, 7}), false);
  EXPECT_GT(i.low, -100);
  EXPECT_GT(i.high, i.value);
}

TEST(MeanEstimate, WhatIsNegativeChangesByItsSize) {
  EXPECT_NEAR(changeOf(alone({-90, -110}), alone({-45, -55}), false).value, 50, 1e-9) << "half as bad";
  const Interval worse = changeOf(alone({-90, -110}), alone({-190, -210}), false);
  EXPECT_NEAR(worse.value, -100, 1e-9);
  EXPECT_LT(worse.low, -100);
  EXPECT_GT(worse.high, -100);
}

TEST(MeanEstimate, AUnitWithoutAValueCountsForNothing) {
  const double none = std::nan("");
  const MeanEstimate some = estimateOf(std::vector<double>{1, 3, none, none, 5, 7}, byTwo(6));
  EXPECT_EQ(some.value, 4);
  EXPECT_EQ(some.degrees, 1);
  EXPECT_EQ(some.deviations[1], 0);
}

TEST(MeanEstimate, DrawsAreStudentsAndTheSameForOneSeed) {
  const auto first = [](const std::vector<double>& m) { return m[0]; };
  Random random(1), again(1);
  std::vector<double> draws = drawMeans({alone(kA)}, {0}, first, random, 40'000);
  EXPECT_EQ(draws, drawMeans({alone(kA)}, {0}, first, again, 40'000));
  std::sort(draws.begin(), draws.end());
  EXPECT_NEAR(quantileOfSorted(draws, 0.025), meanInterval(kA)->low, 0.2);  // s.e. of the quantile 0.06
  EXPECT_NEAR(quantileOfSorted(draws, 0.975), meanInterval(kA)->high, 0.2);
}

TEST(MeanEstimate, DrawsOfOnePairOfUnitsGoTogether) {
  std::vector<double> after = kA;
  for (double& v : after) ++v;
  Random random(1);
  const auto rises = [](const std::vector<double>& m) { return m[0] < m[1] ? 1.0 : 0.0; };
  EXPECT_EQ(meanOf(drawMeans({alone(kA), alone(after)}, {0, 0}, rises, random)), 1);
  EXPECT_LT(meanOf(drawMeans({alone(kA), alone(after)}, {0, 1}, rises, random)), 0.8);
}

}  // namespace surefoot
