// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of samples. Distributions are Boost.Math's. A sample holds finite numbers; where it is too small to say
// anything the answer is empty. Any thread.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/basics/random.h"

namespace surefoot {

using Sample = std::span<const double>;

/// From this number on, equal values show that the values do not scatter; two or three lives with equal falls may be
/// chance.
inline constexpr std::size_t kEnoughAlike = 4;

struct Interval {
  double value = 0.0;            ///< the estimate itself; NaN: there is none
  double low = 0.0, high = 0.0;  ///< ends of the 95 % interval; NaN: there is none, as for one life

  bool known() const { return std::isfinite(low) && std::isfinite(high); }
};

double meanOf(Sample x);
/// Unbiased, n − 1; 0 for fewer than two.
double varianceOf(Sample x);

/// Mean with its 95 % interval by Student's t. Empty for fewer than two, and for two or three that are equal.
std::optional<Interval> meanInterval(Sample x);
/// t(0.975) with so many degrees of freedom: what a standard error is multiplied by.
double tQuantile(double degrees, double confidence = 0.95);

struct TestResult {
  double statistic = 0.0;
  double degrees1 = 0.0, degrees2 = 0.0;  ///< degrees of freedom; a t test has only the first
  double p = 1.0;                         ///< two-sided
};

/// One-way analysis of variance (Fisher): do all groups have one mean? Empty with fewer than two groups, an empty
/// group, or one value a group. Without any variance it is empty where a group has fewer than kEnoughAlike values, else
/// p is 1 for equal means, and 0 for others.
std::optional<TestResult> oneWayAnova(const std::vector<Sample>& groups);
/// The same for two conditions, as the thesis compares them. Empty, too, if one of them has a single value.
std::optional<TestResult> anovaOfTwo(Sample a, Sample b);
/// Welch's t test (1947): the same for two groups whose variances may differ. Empty if the scatter of a group is
/// unknown: it has a single value, or two or three equal ones. Without any variance p is 1 or 0 as above.
std::optional<TestResult> welchTest(Sample a, Sample b);
/// Interval of mean(b) − mean(a), after Welch; empty where the test is empty.
std::optional<Interval> differenceInterval(Sample a, Sample b);
/// Student's t test of the differences of pairs; empty for fewer than two, and for two or three that are equal.
std::optional<TestResult> pairedTest(Sample a, Sample b);
/// Brown & Forsythe (1974): equal variances? An analysis of variance of the distances from the medians.
std::optional<TestResult> brownForsytheTest(const std::vector<Sample>& groups);
/// D'Agostino & Pearson (1973): skewness and kurtosis of a normal distribution? χ² with two degrees of freedom; from 20
/// values on.
std::optional<TestResult> normalityTest(Sample x);
/// Holm (1979): the p values adjusted for being so many; in the order given.
std::vector<double> holm(std::span<const double> p);

/// Hedges' g: (mean(b) − mean(a))/s with s pooled, times 1 − 3/(4·df − 1) for small samples (Hedges 1981).
std::optional<double> effectSize(Sample a, Sample b);
/// Spearman's rank correlation, ties shared; empty if one of the samples is constant.
std::optional<double> rankCorrelation(Sample a, Sample b);

/// How many lives per condition show a difference of two means with the given power, two-sided at `level`, for values
/// with this standard deviation; at most 10⁶. (Normal approximation, with Guenther's (1981) correction of z²/4.)
std::int64_t livesNeeded(double standardDeviation, double difference, double power = 0.8, double level = 0.01);
/// The same for pairs, whose differences have this standard deviation (correction z²/2).
std::int64_t pairsNeeded(double standardDeviation, double difference, double power = 0.8, double level = 0.01);

/// How much of the variance lies between groups of equal size: the random-effects model of one-way analysis of
/// variance.
struct VarianceComponent {
  TestResult test;     ///< test for variance between the groups
  double share = 0.0;  ///< share of the whole variance, 0 … 1
};
std::optional<VarianceComponent> varianceComponent(const std::vector<Sample>& groups);

/// Groups of values that belong together: the lives that began with one Q-function. Lives that share nothing are one
/// group of all.
using Groups = std::vector<std::vector<double>>;

/// 100·(after − before)/|before|: −45 means 45 % fewer. NaN where only `before` is 0; 0 where both are 0.
double changeInPerCent(double before, double after);

/// The q-quantile (0 … 1) of sorted values, linearly between neighbours (Hyndman & Fan 1996, type 7).
double quantileOfSorted(Sample sorted, double q);

}  // namespace surefoot
