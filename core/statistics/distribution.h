// SPDX-License-Identifier: GPL-3.0-or-later
// What a distribution of falls says beside its mean, as a robot's owner asks for it: how bad a bad life is, and how
// often it goes well. Intervals are percentile bootstraps that draw whole units (mean_estimate.h) with replacement
// (Efron & Tibshirani 1993; for IQM and improvement Agarwal et al. 2021, arXiv 2108.13264); below kLeastUnits units
// they are too narrow to be told. Any thread.
#pragma once

#include "core/statistics/mean_estimate.h"

namespace surefoot {

inline constexpr std::size_t kLeastUnits = 8;

/// The mean of the middle half: a quarter of the values is cut at each end, parts of a value by their share. NaN: none.
double interquartileMean(Sample x);
/// The mean of the worst (largest) share of the values, at least one of them: conditional value at risk.
double worstMean(Sample x, double share);
/// The share of pairs in which a value of `a` is below one of `b`, ties by half: Mann–Whitney's U over all pairs.
double improvement(Sample a, Sample b);

/// Of finite values; the interval is unknown for fewer than kLeastUnits units.
Interval bootstrapped(Sample values, const Units& units, const std::function<double(Sample)>& statistic);
/// Of two conditions; `sameUnits`: their units are drawn together.
Interval bootstrappedImprovement(Sample a, const Units& ofA, Sample b, const Units& ofB, bool sameUnits);

}  // namespace surefoot
