// SPDX-License-Identifier: GPL-3.0-or-later
// Against published worked examples. Where only rounded numbers are printed, the tolerance is half of the last digit.
#include "core/statistics/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot {

namespace {

// R's data set PlantGrowth (Dobson 1983): dried weights of plants under a control and two treatments.
const std::vector<double> kControlGroup = {4.17, 5.58, 5.18, 6.11, 4.50, 4.61, 5.17, 4.53, 5.33, 5.14};
const std::vector<double> kFirst = {4.81, 4.17, 4.41, 3.59, 5.87, 3.83, 6.03, 4.89, 4.32, 4.69};
const std::vector<double> kSecond = {6.31, 5.12, 5.54, 5.50, 5.37, 5.29, 4.92, 6.15, 5.80, 5.26};
// R's data set sleep (Student 1908): hours gained by two drugs, by the same ten people.
const std::vector<double> kDrug1 = {0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const std::vector<double> kDrug2 = {1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

}  // namespace

TEST(Statistics, OneWayAnovaOfPlantGrowth) {  // R: summary(aov(weight ~ group)): F 4.846, p 0.0159
  const auto t = oneWayAnova({kControlGroup, kFirst, kSecond});
  ASSERT_TRUE(t);
  EXPECT_NEAR(t->statistic, 4.846, 5e-4);
  EXPECT_EQ(t->degrees1, 2);
  EXPECT_EQ(t->degrees2, 27);
  EXPECT_NEAR(t->p, 0.01591, 5e-6);
}

TEST(Statistics, AnovaWithoutVarianceSaysEqualOrDifferent) {
  const std::vector<double> a = {1, 1, 1}, b = {2, 2, 2};
  const std::vector<double> four = {1, 1, 1, 1};
  EXPECT_EQ(oneWayAnova({four, four})->p, 1.0);
  EXPECT_FALSE(oneWayAnova({a}));
  EXPECT_FALSE(oneWayAnova({a, {}}));
  EXPECT_FALSE(anovaOfTwo(a, b)) << "three equal falls happen by chance";
  EXPECT_EQ(anovaOfTwo(std::vector<double>{1, 1, 1, 1}, std::vector<double>{2, 2, 2, 2})->p, 0.0);
  EXPECT_FALSE(anovaOfTwo(a, std::vector<double>{2})) << "one value has no scatter";
}

TEST(Statistics, WelchAndPairedTestOfSleep) {  // R: t.test(extra ~ group): t −1.8608, df 17.776, p 0.07939
  const auto welch = welchTest(kDrug1, kDrug2);
  ASSERT_TRUE(welch);
  EXPECT_NEAR(welch->statistic, 1.8608, 5e-5);
  EXPECT_NEAR(welch->degrees1, 17.776, 5e-4);
  EXPECT_NEAR(welch->p, 0.07939, 5e-6);
  const auto interval = differenceInterval(kDrug1, kDrug2);  // −3.3654832  0.2054832, the other way round
  EXPECT_NEAR(interval->low, -0.2054832, 5e-8);
  EXPECT_NEAR(interval->high, 3.3654832, 5e-8);
  const auto paired = pairedTest(kDrug1, kDrug2);  // paired = TRUE: t −4.0621, df 9, p 0.002833
  EXPECT_NEAR(paired->statistic, 4.0621, 5e-5);
  EXPECT_EQ(paired->degrees1, 9);
  EXPECT_NEAR(paired->p, 0.002833, 5e-7);
}

TEST(Statistics, MeanIntervalByStudent) {  // t(0.975, 9) = 2.262157 (tables)
  const auto i = meanInterval(kDrug1);
  ASSERT_TRUE(i);
  EXPECT_NEAR(i->value, 0.75, 1e-12);
  EXPECT_NEAR(i->high - i->value, 2.262157 * std::sqrt(varianceOf(kDrug1) / 10), 1e-6);
  EXPECT_FALSE(meanInterval(std::vector<double>{1.0}));
}

TEST(Statistics, BrownForsytheOfPlantGrowth) {  // R, car::leveneTest(weight ~ group): F 1.1192, p 0.3412
  const auto t = brownForsytheTest({kControlGroup, kFirst, kSecond});
  EXPECT_NEAR(t->statistic, 1.1192, 5e-5);
  EXPECT_NEAR(t->p, 0.3412, 5e-5);
}

TEST(Statistics, NormalityAsInScipy) {  // scipy.stats.normaltest, SciPy 1.10.1
  std::vector<double> plants = kControlGroup;
  plants.insert(plants.end(), kFirst.begin(), kFirst.end());
  plants.insert(plants.end(), kSecond.begin(), kSecond.end());
  EXPECT_NEAR(normalityTest(plants)->statistic, 0.5683353492831906, 1e-10);
  EXPECT_NEAR(normalityTest(plants)->p, 0.7526404354101851, 1e-10);
  const std::vector<double> skewed = {148, 154, 158, 160, 161, 162, 166, 170, 182, 195,
                                      236, 150, 155, 159, 163, 165, 168, 171, 172, 180};
  EXPECT_NEAR(normalityTest(skewed)->statistic, 25.62592532690408, 1e-9);
  EXPECT_NEAR(normalityTest(skewed)->p, 2.72521655453619e-06, 1e-14);
  EXPECT_FALSE(normalityTest(kDrug1)) << "too few";
}

TEST(Statistics, HolmAdjustsInTheOrderGiven) {  // R: p.adjust(c(.01, .04, .03, .005), "holm"): .03 .06 .06 .02
  const std::vector<double> p = {0.01, 0.04, 0.03, 0.005}, expected = {0.03, 0.06, 0.06, 0.02};
  const auto adjusted = holm(p);
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_NEAR(adjusted[i], expected[i], 1e-12);
  EXPECT_EQ(holm(std::vector<double>{0.9, 0.8}), (std::vector<double>{1.0, 1.0}));
  EXPECT_TRUE(holm({}).empty());
}

TEST(Statistics, EffectSizeOfSleep) {
  // d = 1.58/1.898964 = 0.83221 (R, effsize::cohen.d), times 1 − 3/71
  EXPECT_NEAR(*effectSize(kDrug1, kDrug2), 0.83221 * (1 - 3.0 / 71), 5e-5);
}

TEST(Statistics, RankCorrelationSharesTies) {
  // The worked example of IQ and hours of television that textbooks print: −0.17575757…
  const std::vector<double> iq = {106, 100, 86, 101, 99, 103, 97, 113, 112, 110},
                            hours = {7, 27, 2, 50, 28, 29, 20, 12, 6, 17};
  EXPECT_NEAR(*rankCorrelation(iq, hours), -29.0 / 165, 1e-12);
  // SciPy: spearmanr([1, 2, 2, 3], [1, 3, 2, 2]) = 0.5
  EXPECT_NEAR(*rankCorrelation(std::vector<double>{1, 2, 2, 3}, std::vector<double>{1, 3, 2, 2}), 0.5, 1e-12);
  EXPECT_FALSE(rankCorrelation(std::vector<double>{1, 1}, std::vector<double>{1, 2}));
}

TEST(Statistics, LivesNeededAsPowerTTest) {
  // R: power.t.test(delta = 1, sd = 1, power = .8): n 16.71; delta = 0.5: n 63.77; power = .9: 22.02
  EXPECT_EQ(livesNeeded(1, 1, 0.8, 0.05), 17);
  EXPECT_EQ(livesNeeded(1, -0.5, 0.8, 0.05), 64);
  EXPECT_EQ(livesNeeded(1, 1, 0.9, 0.05), 22);  // 22.02 rounded up would be 23; the approximation gives 21.97
  EXPECT_EQ(livesNeeded(1, 0), 1'000'000);
  // Noncentral t (sig.level = .01, power .8): 24.9 lives a side and 95.1; of pairs 15.1 and 50.3. The level of the X.
  EXPECT_NEAR(static_cast<double>(livesNeeded(1, 1)), 25, 1);
  EXPECT_NEAR(static_cast<double>(livesNeeded(1, 0.5)), 96, 1);
  EXPECT_NEAR(static_cast<double>(pairsNeeded(1, 1)), 15, 1);
  EXPECT_NEAR(static_cast<double>(pairsNeeded(1, -0.5)), 51, 1);
}

TEST(Statistics, VarianceComponentOfDyestuff) {
  // Davies 1947; R, lme4: Batch 1764, Residual 2451
  const std::vector<std::vector<double>> batches = {{1545, 1440, 1440, 1520, 1580}, {1540, 1555, 1490, 1560, 1495},
                                                    {1595, 1550, 1605, 1510, 1560}, {1445, 1440, 1595, 1465, 1545},
                                                    {1595, 1630, 1515, 1635, 1625}, {1520, 1455, 1450, 1480, 1445}};
  const auto component = varianceComponent({batches.begin(), batches.end()});
  ASSERT_TRUE(component);
  EXPECT_NEAR(component->share, 1764.05 / (1764.05 + 2451.25), 1e-9);
  EXPECT_NEAR(component->test.statistic, 4.598, 5e-4);
}

TEST(Statistics, QuantilesAsInR) {  // quantile(c(1, 2, 3, 4, 10), c(.1, .5, .975)), type 7
  const std::vector<double> x = {1, 2, 3, 4, 10};
  EXPECT_NEAR(quantileOfSorted(x, 0.1), 1.4, 1e-12);
  EXPECT_EQ(quantileOfSorted(x, 0.5), 3);
  EXPECT_NEAR(quantileOfSorted(x, 0.975), 9.4, 1e-12);
  EXPECT_EQ(quantileOfSorted(x, 1.0), 10);
}

TEST(Statistics, ChangeInPerCent) {
  EXPECT_DOUBLE_EQ(changeInPerCent(20, 11), -45);
  EXPECT_DOUBLE_EQ(changeInPerCent(0, 0), 0);
  EXPECT_TRUE(std::isnan(changeInPerCent(0, 3))) << "of nothing there are no per cent";
  EXPECT_DOUBLE_EQ(changeInPerCent(-100, -150), -50) << "worse by half";
}

TEST(Statistics, WithoutVarianceTheMeansDecide) {
  const std::vector<double> three = {3, 3, 3, 3}, four = {4, 4, 4, 4, 4};
  EXPECT_EQ(welchTest(three, three)->p, 1.0);
  EXPECT_EQ(welchTest(three, four)->p, 0.0);
  EXPECT_EQ(differenceInterval(three, four)->low, 1.0);
  EXPECT_EQ(differenceInterval(three, four)->high, 1.0);
  EXPECT_EQ(oneWayAnova({three, four})->p, 0.0);
}

TEST(Statistics, TwoOrThreeEqualValuesProveNothing) {
  const std::vector<double> ones = {1, 1}, twos = {2, 2}, same = {2, 2, 2}, some = {1, 2, 4, 4, 9}, more = {2, 3, 5};
  EXPECT_FALSE(oneWayAnova({ones, twos})) << "else p were 0";
  EXPECT_FALSE(welchTest(ones, twos));
  EXPECT_FALSE(welchTest(same, some)) << "how the first scatters nobody knows";
  EXPECT_FALSE(differenceInterval(some, twos));
  EXPECT_FALSE(meanInterval(same));
  EXPECT_FALSE(pairedTest(ones, twos));
  EXPECT_FALSE(pairedTest(std::vector<double>{1, 2, 4}, more)) << "each is one more";
  EXPECT_TRUE(pairedTest(std::vector<double>{1, 2, 3}, more));
  EXPECT_FALSE(varianceComponent({ones, twos})) << "two Q-functions of two lives each";
}

}  // namespace surefoot
