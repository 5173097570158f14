// SPDX-License-Identifier: GPL-3.0-or-later
// Whether 95 % intervals hold their 95 %: 2,000 experiments a cell, of whose true values we know. From three lives on
// every cell lies between 92 and 98 %; the standard error of a cell is half a per cent.
#include <gtest/gtest.h>

#include <cmath>

#include "core/statistics/mean_estimate.h"

namespace surefoot {

namespace {

constexpr int kExperiments = 2000, kQFunctions = 5;

/// Standard normal (Box & Muller).
double normal(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * std::acos(-1.0) * random.uniform());
}

/// Falls of a life: a Poisson number whose mean is Γ-distributed, so that it is negative binomial. Mean 23 and standard
/// deviation 10 are those of ε-greedy after pre-learning on scenario 2.
double falls(double mean, double deviation, Random& random) {
  const double shape = mean * mean / (deviation * deviation - mean);
  double gamma = 0;  // Marsaglia & Tsang
  for (const double d = shape - 1.0 / 3, c = 1 / std::sqrt(9 * d); gamma == 0;) {
    const double z = normal(random), v = std::pow(1 + c * z, 3);
    if (v > 0 && std::log(1 - random.uniform()) < z * z / 2 + d * (1 - v + std::log(v))) gamma = d * v / shape * mean;
  }
  int count = -1;
  for (double left = gamma; left > 0; ++count) left += std::log(1 - random.uniform());
  return count;
}

/// A condition of an experiment, with the mean that its lives would have if there were enough of them.
struct Lives {
  std::vector<double> values{};
  Units units{};
};
struct TwoConditions {
  Lives before{}, after{};
  double trueBefore = 1, trueAfter = 1;
  bool same = false;
};
using Make = std::function<TwoConditions(std::size_t lives, Random&)>;

TwoConditions bell(std::size_t lives, Random& random) {
  TwoConditions two{.trueBefore = 200, .trueAfter = 110};
  for (Lives* l : {&two.before, &two.after}) l->units = Units::each(lives);
  for (std::size_t i = 0; i < lives; ++i) {
    two.before.values.push_back(200 + 40 * normal(random));
    two.after.values.push_back(110 + 33 * normal(random));
  }
  return two;
}

TwoConditions skewed(std::size_t lives, Random& random) {
  TwoConditions two{.trueBefore = 23, .trueAfter = 13};
  for (Lives* l : {&two.before, &two.after}) l->units = Units::each(lives);
  for (std::size_t i = 0; i < lives; ++i) {
    two.before.values.push_back(falls(23, 10, random));
    two.after.values.push_back(falls(13, 7, random));
  }
  return two;
}

/// The lives take turns with a few Q-functions, which carry more than half of the variance; of both conditions the same
/// or not.
TwoConditions pooled(std::size_t lives, bool same, Random& random) {
  TwoConditions two{.trueBefore = 200, .trueAfter = 110, .same = same};
  const std::size_t q = std::min<std::size_t>(kQFunctions, lives);
  std::vector<double> first(q), second(q);
  for (std::size_t g = 0; g < q; ++g) {
    first[g] = normal(random);
    second[g] = same ? 0.8 * first[g] + 0.6 * normal(random) : normal(random);
  }
  for (Lives* l : {&two.before, &two.after}) l->units.count = q;
  for (std::size_t i = 0; i < lives; ++i) {
    for (Lives* l : {&two.before, &two.after}) l->units.of.push_back(i % q);
    two.before.values.push_back(200 + 40 * first[i % q] + 30 * normal(random));
    two.after.values.push_back(110 + 25 * second[i % q] + 20 * normal(random));
  }
  return two;
}

/// Life i has the same seeds in both.
TwoConditions pairedLives(std::size_t lives, Random& random) {
  TwoConditions two{.trueBefore = 200, .trueAfter = 110, .same = true};
  for (Lives* l : {&two.before, &two.after}) l->units = Units::each(lives);
  for (std::size_t i = 0; i < lives; ++i) {
    const double common = normal(random);
    two.before.values.push_back(200 + 40 * common + 20 * normal(random));
    two.after.values.push_back(110 + 22 * common + 10 * normal(random));
  }
  return two;
}

bool holds(const Interval& i, double truth) {
  return i.low <= truth && truth <= i.high;
}

/// Shares in which the intervals of mean, difference and change hold the truth.
void expectCoverage(const char* name, const Make& make) {
  for (const std::size_t lives : {3, 5, 10, 40}) {
    Random random(lives);
    double mean = 0, difference = 0, change = 0;
    for (int i = 0; i < kExperiments; ++i) {
      const TwoConditions two = make(lives, random);
      const MeanEstimate before = estimateOf(two.before.values, two.before.units),
                         after = estimateOf(two.after.values, two.after.units);
      mean += holds(intervalOf(before), two.trueBefore);
      difference += holds(differenceOf(before, after, two.same), two.trueAfter - two.trueBefore);
      change += holds(changeOf(before, after, two.same), changeInPerCent(two.trueBefore, two.trueAfter));
    }
    for (const auto& [what, held] : {std::pair{"mean", mean}, {"difference", difference}, {"change", change}}) {
      const double perCent = 100 * held / kExperiments;
      EXPECT_GE(perCent, 92) << name << ", " << lives << " lives, " << what;
      EXPECT_LE(perCent, 98) << name << ", " << lives << " lives, " << what;
      testing::Test::RecordProperty(std::string(name) + "-" + what + "-" + std::to_string(lives),
                                    std::to_string(perCent));
    }
  }
}

}  // namespace

TEST(Coverage, OfNormalLives) {
  expectCoverage("normal", bell);
}

TEST(Coverage, OfSkewedFalls) {
  expectCoverage("skewed", skewed);
}

TEST(Coverage, OfLivesThatShareAFewQFunctions) {
  expectCoverage("pooled", [](std::size_t lives, Random& random) { return pooled(lives, false, random); });
}

TEST(Coverage, OfConditionsThatShareTheirQFunctions) {
  expectCoverage("shared", [](std::size_t lives, Random& random) { return pooled(lives, true, random); });
}

TEST(Coverage, OfPairs) {
  expectCoverage("paired", pairedLives);
}

TEST(Coverage, LivesOfAPoolTakenForIndependentWouldNotHoldIt) {  // so the cells above can fail
  Random random(1);
  double held = 0;
  for (int i = 0; i < kExperiments; ++i) {
    const TwoConditions two = pooled(40, false, random);
    held += holds(intervalOf(estimateOf(two.before.values, Units::each(40))), two.trueBefore);
  }
  EXPECT_LT(held / kExperiments, 0.75);
}

TEST(Coverage, EqualConditionsSeldomSeemInOrder) {  // a claim of order agrees at 95 % of the draws: in 5 % by chance
  for (const std::size_t lives : {2, 3, 5, 10}) {
    Random random(lives), draws(1);
    int agreed = 0;
    constexpr int kTries = 1000;
    for (int i = 0; i < kTries; ++i) {
      std::vector<MeanEstimate> means;
      for (int c = 0; c < 2; ++c) {
        std::vector<double> values;
        for (std::size_t l = 0; l < lives; ++l) values.push_back(falls(23, 10, random));
        means.push_back(estimateOf(values, Units::each(lives)));
      }
      const auto rises = [](const std::vector<double>& m) { return m[0] < m[1] ? 1.0 : 0.0; };
      agreed += meanOf(drawMeans(means, {0, 1}, rises, draws, 400)) >= 0.95;
    }
    EXPECT_LT(agreed, 0.07 * kTries) << lives << " lives";
  }
}

}  // namespace surefoot
