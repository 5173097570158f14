// SPDX-License-Identifier: GPL-3.0-or-later
// A mean over lives and how far it can be trusted. What is independent of each other is a *unit*: a life; or, where
// lives share the Q-functions of a pool, all lives of one Q-function together. Intervals are Student's t with as many
// degrees of freedom as there are units but one; of two means that share nothing, Welch & Satterthwaite's (1947). From
// three units on they hold their 95 % within three points (coverage_test); up to an end of learning that the units tell
// themselves, within about five (end_coverage_test). Of one unit there is none. Any thread.
#pragma once

#include <cmath>
#include <functional>
#include <limits>

#include "core/statistics/statistics.h"

namespace surefoot {

/// Which values belong to one unit.
struct Units {
  std::vector<std::size_t> of;  ///< of every value: the number of its unit, from 0
  std::size_t count = 0;
  bool areQFunctions = false;

  /// Every value is a unit of its own.
  static Units each(std::size_t values);
};

struct MeanEstimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  /// Their squares add up to the squared standard error. Of conditions whose units are the same ones they stand in the
  /// same order, so that the error of a difference is that of their differences.
  std::vector<double> deviations;
  double degrees = 0.0;       ///< of freedom; 0: no error can be told, of one unit or of two or three that are equal
  bool neverNegative = true;  ///< as counts are
  bool resampled = false;     ///< the deviations are those of resamples, not of units

  bool known() const { return degrees > 0; }
  double squaredError() const;
};

/// The mean of all values that are numbers. A unit weighs as many as it holds.
MeanEstimate estimateOf(Sample values, const Units& units);
/// Of means that were found in resamples of so many units.
MeanEstimate estimateOf(double value, Sample resampled, std::size_t units);

/// Both have their deviations in one order: those of units, or of resamples. Of two conditions with the same units of
/// which only one ends elsewhere in other resamples, they are not, and the interval is that of two apart: it is wider.
bool arePairs(const MeanEstimate& a, const MeanEstimate& b);
/// Two or three pairs that differ by the same do not tell how differences scatter.
bool tellsDifference(const MeanEstimate& a, const MeanEstimate& b);

Interval intervalOf(const MeanEstimate& mean);
/// after − before. `sameUnits`: the units of both are the same ones.
Interval differenceOf(const MeanEstimate& before, const MeanEstimate& after, bool sameUnits);
/// after/before. Of what is never negative by the logarithm, so that it is above 0. NaN where `before` is 0; no
/// interval where `after` is.
Interval ratioOf(const MeanEstimate& before, const MeanEstimate& after, bool sameUnits);
/// 100·(after − before)/|before|, with the interval of the ratio; NaN where `before` is 0.
Interval changeOf(const MeanEstimate& before, const MeanEstimate& after, bool sameUnits);

/// `f` of means drawn as far from ours as the lives leave them uncertain (Student's t), so many times, in order: what
/// is true in how many of them. Conditions with one number in `together` have the same units and are drawn with the
/// same random numbers. Empty if one of the means has no error that is known, or two
/// of the same units have differences of which none is.
std::vector<double> drawMeans(const std::vector<MeanEstimate>& means, const std::vector<std::size_t>& together,
                              const std::function<double(const std::vector<double>&)>& f, Random& random,
                              int count = 10'000);

}  // namespace surefoot
