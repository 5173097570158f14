// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/distribution.h"

#include <algorithm>
#include <numeric>

#include "core/basics/random.h"

namespace surefoot {

namespace {

constexpr int kDraws = 1000;
constexpr std::uint64_t kSeed = 1;  // the same store always gives the same intervals
constexpr double kTail = 0.025;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::vector<double> finite(Sample values) {
  std::vector<double> all;
  std::copy_if(values.begin(), values.end(), std::back_inserter(all), [](double v) { return std::isfinite(v); });
  return all;
}

/// The finite values of each unit.
std::vector<std::vector<double>> byUnit(Sample values, const Units& units) {
  std::vector<std::vector<double>> groups(units.count);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i])) groups[units.of[i]].push_back(values[i]);
  return groups;
}

std::vector<std::size_t> drawn(std::size_t units, Random& random) {
  std::vector<std::size_t> of(units);
  for (std::size_t& unit : of) unit = static_cast<std::size_t>(random.uniform() * static_cast<double>(units));
  return of;
}

std::vector<double> together(const std::vector<std::vector<double>>& groups, const std::vector<std::size_t>& units) {
  std::vector<double> all;
  for (const std::size_t unit : units) all.insert(all.end(), groups[unit].begin(), groups[unit].end());
  return all;
}

Interval middleOf(double value, std::vector<double> results) {
  std::erase_if(results, [](double v) { return !std::isfinite(v); });
  if (results.size() < kDraws / 2) return {value, kUnknown, kUnknown};
  std::sort(results.begin(), results.end());
  return {value, quantileOfSorted(results, kTail), quantileOfSorted(results, 1 - kTail)};
}

}  // namespace

double interquartileMean(Sample x) {
  std::vector<double> sorted(x.begin(), x.end());
  if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(sorted.begin(), sorted.end());
  const double n = static_cast<double>(sorted.size()), from = n / 4, to = 3 * n / 4;
  double sum = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double begin = static_cast<double>(i);
    sum += sorted[i] * std::max(0.0, std::min(begin + 1, to) - std::max(begin, from));
  }
  return sum / (to - from);
}

double worstMean(Sample x, double share) {
  std::vector<double> sorted(x.begin(), x.end());
  if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  const auto count = std::max<std::size_t>(1, static_cast<std::size_t>(share * static_cast<double>(sorted.size())));
  return std::accumulate(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count), 0.0) /
         static_cast<double>(count);
}

double improvement(Sample a, Sample b) {
  std::vector<double> sorted(b.begin(), b.end());
  std::sort(sorted.begin(), sorted.end());
  double wins = 0;
  for (const double value : a) {
    const auto [from, to] = std::equal_range(sorted.begin(), sorted.end(), value);
    wins += static_cast<double>(sorted.end() - to) + 0.5 * static_cast<double>(to - from);
  }
  return wins / (static_cast<double>(a.size()) * static_cast<double>(b.size()));
}

Interval bootstrapped(Sample values, const Units& units, const std::function<double(Sample)>& statistic) {
  const double value = statistic(finite(values));
  if (units.count < kLeastUnits) return {value, kUnknown, kUnknown};
  const auto groups = byUnit(values, units);
  Random random(kSeed);
  std::vector<double> results;
  for (int i = 0; i < kDraws; ++i) results.push_back(statistic(together(groups, drawn(units.count, random))));
  return middleOf(value, std::move(results));
}

Interval bootstrappedImprovement(Sample a, const Units& ofA, Sample b, const Units& ofB, bool sameUnits) {
  const double value = improvement(finite(a), finite(b));
  if (std::min(ofA.count, ofB.count) < kLeastUnits) return {value, kUnknown, kUnknown};
  const auto groupsA = byUnit(a, ofA), groupsB = byUnit(b, ofB);
  Random random(kSeed);
  std::vector<double> results;
  for (int i = 0; i < kDraws; ++i) {
    const auto unitsA = drawn(ofA.count, random);
    const auto unitsB = sameUnits ? unitsA : drawn(ofB.count, random);
    results.push_back(improvement(together(groupsA, unitsA), together(groupsB, unitsB)));
  }
  return middleOf(value, std::move(results));
}

}  // namespace surefoot
