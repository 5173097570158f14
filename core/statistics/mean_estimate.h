// SPDX-License-Identifier: GPL-3.0-or-later
// A mean over lives and how far it can be trusted. Independent samples are called *units*: a unit is a life; or, where
// lives share the Q-functions of a pool, all lives of one Q-function together. Intervals are Student's t; n units have
// n − 1 degrees of freedom, and two means without common units those of Welch & Satterthwaite (1947). From three units
// on the intervals cover 95 % within three points (coverage_test); for measures up to an end of learning that is found
// from the same units, within about five (end_coverage_test). One unit has no interval. Any thread.
#pragma once

#include <cmath>
#include <functional>
#include <limits>

#include "core/statistics/statistics.h"

namespace surefoot {

/// Which values belong to one unit.
struct Units {
  std::vector<std::size_t> of;  ///< for every value the number of its unit, from 0
  std::size_t count = 0;
  bool areQFunctions = false;

  /// Every value is a unit of its own.
  static Units each(std::size_t values);
};

struct MeanEstimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  /// Their squares add up to the squared standard error. Conditions with the same units have them in the same order:
  /// then the squared error of a difference is the sum of the squared differences of the deviations.
  std::vector<double> deviations;
  double degrees = 0.0;       ///< degrees of freedom; 0: the error is unknown (one unit, or two or three equal ones)
  bool neverNegative = true;  ///< no value is below 0, as with counts
  bool resampled = false;     ///< there is a deviation for each resample, not for each unit

  bool known() const { return degrees > 0; }
  double squaredError() const;
};

/// The mean of all finite values. The weight of a unit is the number of its values.
MeanEstimate estimateOf(Sample values, const Units& units);
/// An estimate whose error comes from resamples: `resampled` are their means, `units` the number of units.
MeanEstimate estimateOf(double value, Sample resampled, std::size_t units);

/// Whether the deviations of both are in the same order, of units or of resamples. If only one of two conditions with
/// the same units is resampled, they are no pairs: then the wider interval of two independent means is used.
bool arePairs(const MeanEstimate& a, const MeanEstimate& b);
/// Whether the scatter of the differences is known. Two or three pairs with the same difference do not show it.
bool tellsDifference(const MeanEstimate& a, const MeanEstimate& b);

Interval intervalOf(const MeanEstimate& mean);
/// after − before. `sameUnits`: both have the same units. This and the next two at another confidence than 95 % if
/// asked for.
Interval differenceOf(const MeanEstimate& before, const MeanEstimate& after, bool sameUnits, double confidence = 0.95);
/// after/before. For values that are never negative the interval is computed for the logarithm, so that it lies above
/// 0. NaN where `before` is 0; no interval where `after` is 0.
Interval ratioOf(const MeanEstimate& before, const MeanEstimate& after, bool sameUnits, double confidence = 0.95);
/// 100·(after − before)/|before|, with the interval of the ratio; NaN where `before` is 0.
Interval changeOf(const MeanEstimate& before, const MeanEstimate& after, bool sameUnits, double confidence = 0.95);

/// Draws all means `count` times, each around our value with its error (Student's t), and returns `f` of every draw:
/// to count how often something is true. Conditions with the same number in `together` have the same units and are
/// drawn with the same random numbers. Empty if the error of a mean is unknown, or the error of a difference between
/// two means with the same units.
std::vector<double> drawMeans(const std::vector<MeanEstimate>& means, const std::vector<std::size_t>& together,
                              const std::function<double(const std::vector<double>&)>& f, Random& random,
                              int count = 10'000);

}  // namespace surefoot
