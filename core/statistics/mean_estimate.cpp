// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/mean_estimate.h"

#include <algorithm>
#include <numeric>

namespace surefoot {

namespace {

const double kNothing = std::numeric_limits<double>::quiet_NaN();

Interval around(double value, double half) {
  return {value, value - half, value + half};
}

/// The squared standard error of weightB·b − weightA·a, for pairs.
double squaredErrorOfPairs(const MeanEstimate& a, double weightA, const MeanEstimate& b, double weightB) {
  double squares = 0;
  for (std::size_t i = 0; i < a.deviations.size(); ++i) {
    const double d = weightB * b.deviations[i] - weightA * a.deviations[i];
    squares += d * d;
  }
  return squares;
}

/// Whether the scatter of the differences is known: two or three that are equal (but for rounding) do not show it.
bool differencesScatter(double squares, double ofA, double ofB, double degrees) {
  constexpr double kRounding = 1e-24;
  return degrees + 1 >= kEnoughAlike || squares > kRounding * (ofA + ofB);
}

/// Half the width of the interval: the standard error of weightB·b − weightA·a times the quantile of t.
double halfWidth(const MeanEstimate& a, double weightA, const MeanEstimate& b, double weightB, bool sameUnits,
                 double confidence) {
  if (!a.known() || !b.known()) return kNothing;
  const double ofA = weightA * weightA * a.squaredError(), ofB = weightB * weightB * b.squaredError();
  if (sameUnits && arePairs(a, b)) {
    const double squares = squaredErrorOfPairs(a, weightA, b, weightB), degrees = std::min(a.degrees, b.degrees);
    return differencesScatter(squares, ofA, ofB, degrees) ? tQuantile(degrees, confidence) * std::sqrt(squares)
                                                          : kNothing;
  }
  if (ofA + ofB == 0) return 0;
  const double degrees = (ofA + ofB) * (ofA + ofB) / (ofA * ofA / a.degrees + ofB * ofB / b.degrees);
  return tQuantile(degrees, confidence) * std::sqrt(ofA + ofB);
}

}  // namespace

Units Units::each(std::size_t values) {
  Units units{.of = std::vector<std::size_t>(values), .count = values};
  std::iota(units.of.begin(), units.of.end(), std::size_t{0});
  return units;
}

bool arePairs(const MeanEstimate& a, const MeanEstimate& b) {
  return a.resampled == b.resampled && a.deviations.size() == b.deviations.size();
}

bool tellsDifference(const MeanEstimate& a, const MeanEstimate& b) {
  if (!arePairs(a, b)) return true;
  return differencesScatter(squaredErrorOfPairs(a, 1, b, 1), a.squaredError(), b.squaredError(),
                            std::min(a.degrees, b.degrees));
}

double MeanEstimate::squaredError() const {
  return std::inner_product(deviations.begin(), deviations.end(), deviations.begin(), 0.0);
}

// With units of n_g values and means m_g: d_g = √(G/(G − 1))·n_g/n·(m_g − m). For units of equal size Σ d_g² is the
// variance of the m_g over G.
MeanEstimate estimateOf(Sample values, const Units& units) {
  MeanEstimate estimate;
  double sum = 0, count = 0;
  std::vector<double> sums(units.count), counts(units.count);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    sum += values[i], ++count;
    sums[units.of[i]] += values[i], ++counts[units.of[i]];
    estimate.neverNegative &= values[i] >= 0;
  }
  if (count == 0) return estimate;
  estimate.value = sum / count;
  const auto there = static_cast<double>(std::count_if(counts.begin(), counts.end(), [](double n) { return n > 0; }));
  if (there < 2) return estimate;
  const double factor = std::sqrt(there / (there - 1)) / count;
  for (std::size_t g = 0; g < units.count; ++g)
    estimate.deviations.push_back(factor * (sums[g] - counts[g] * estimate.value));  // 0 for a unit without a value
  if (there >= kEnoughAlike || estimate.squaredError() > 0) estimate.degrees = there - 1;
  return estimate;
}

// With G units the bootstrap's standard error is too small by the factor √((G − 1)/G). Deviations are taken from our
// value, not from the mean of the resamples: resamples end learning earlier, as fewer lives do, and this shift is part
// of the uncertainty.
MeanEstimate estimateOf(double value, Sample resampled, std::size_t units) {
  MeanEstimate estimate{.value = value, .deviations = {}, .resampled = true};
  if (units < 2 || resampled.size() < 2) return estimate;
  const double all = static_cast<double>(units);
  const double factor = std::sqrt(all / (all - 1) / static_cast<double>(resampled.size() - 1));
  for (const double v : resampled) estimate.deviations.push_back(factor * (v - value));
  estimate.degrees = all - 1;
  return estimate;
}

Interval intervalOf(const MeanEstimate& mean) {
  if (!mean.known()) return {mean.value, kNothing, kNothing};
  return around(mean.value, tQuantile(mean.degrees) * std::sqrt(mean.squaredError()));
}

Interval differenceOf(const MeanEstimate& before, const MeanEstimate& after, bool sameUnits, double confidence) {
  return around(after.value - before.value, halfWidth(before, 1, after, 1, sameUnits, confidence));
}

Interval ratioOf(const MeanEstimate& before, const MeanEstimate& after, bool sameUnits, double confidence) {
  if (!std::isfinite(before.value) || !std::isfinite(after.value) || before.value == 0)
    return {kNothing, kNothing, kNothing};
  const double ratio = after.value / before.value;
  if (!before.neverNegative || !after.neverNegative)
    return around(ratio, std::abs(halfWidth(before, ratio, after, 1, sameUnits, confidence) / before.value));
  if (after.value == 0) return {ratio, kNothing, kNothing};  // without any fall their rate is unknown
  const double half = halfWidth(before, 1 / before.value, after, 1 / after.value, sameUnits, confidence);
  return {ratio, ratio * std::exp(-half), ratio * std::exp(half)};
}

Interval changeOf(const MeanEstimate& before, const MeanEstimate& after, bool sameUnits, double confidence) {
  const Interval ratio = ratioOf(before, after, sameUnits, confidence);
  if (before.value > 0) return {100 * (ratio.value - 1), 100 * (ratio.low - 1), 100 * (ratio.high - 1)};
  return {100 * (1 - ratio.value), 100 * (1 - ratio.high), 100 * (1 - ratio.low)};
}

}  // namespace surefoot
