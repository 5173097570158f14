// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/statistics.h"
#include "core/basics/expects.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace surefoot {

namespace {

namespace dist = boost::math;

double count(Sample x) {
  return static_cast<double>(x.size());
}

/// The upper tail of F, also where a variance is 0.
double tailOfF(double f, double degrees1, double degrees2) {
  if (std::isnan(f)) return 1.0;  // 0/0: nothing differs
  if (std::isinf(f)) return 0.0;
  return dist::cdf(dist::complement(dist::fisher_f(degrees1, degrees2), f));
}

double twoTailsOfT(double t, double degrees) {
  if (std::isnan(t)) return 1.0;
  if (std::isinf(t)) return 0.0;
  return 2.0 * dist::cdf(dist::complement(dist::students_t(degrees), std::abs(t)));
}

double medianOf(Sample x) {
  std::vector<double> sorted(x.begin(), x.end());
  std::sort(sorted.begin(), sorted.end());
  return quantileOfSorted(sorted, 0.5);
}

/// 1, 2, … in order of size; equal values share the mean of their ranks.
std::vector<double> ranksOf(Sample x) {
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return x[i] < x[j]; });
  std::vector<double> ranks(x.size());
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && x[order[end]] == x[order[begin]]) ++end;
    for (std::size_t i = begin; i < end; ++i) ranks[order[i]] = 0.5 * static_cast<double>(begin + 1 + end);
  }
  return ranks;
}

/// Whether a sample shows how its values scatter.
bool scatters(Sample x) {
  return x.size() >= kEnoughAlike || (x.size() >= 2 && varianceOf(x) > 0);
}

struct SquaredStandardErrors {
  double a, b;
  double sum() const { return a + b; }
};
SquaredStandardErrors squaredStandardErrors(Sample a, Sample b) {
  return {varianceOf(a) / count(a), varianceOf(b) / count(b)};
}

/// Welch and Satterthwaite's degrees of freedom.
double welchDegrees(Sample a, Sample b) {
  const auto s = squaredStandardErrors(a, b);
  if (s.sum() == 0.0) return count(a) + count(b) - 2;
  return s.sum() * s.sum() / (s.a * s.a / (count(a) - 1) + s.b * s.b / (count(b) - 1));
}

}  // namespace

double meanOf(Sample x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / count(x);
}

double varianceOf(Sample x) {
  if (x.size() < 2) return 0.0;
  const double mean = meanOf(x);
  double squares = 0.0;
  for (const double v : x) squares += (v - mean) * (v - mean);
  return squares / (count(x) - 1);
}

double tQuantile(double degrees, double confidence) {
  return dist::quantile(dist::students_t(degrees), (1 + confidence) / 2);
}

std::optional<Interval> meanInterval(Sample x) {
  if (!scatters(x)) return std::nullopt;
  const double mean = meanOf(x), half = tQuantile(count(x) - 1) * std::sqrt(varianceOf(x) / count(x));
  return Interval{mean, mean - half, mean + half};
}

// F = (Σ n_i (x̄_i − x̄)²/(k − 1)) / (Σ Σ (x_ij − x̄_i)²/(n − k))
std::optional<TestResult> oneWayAnova(const std::vector<Sample>& groups) {
  double n = 0, sum = 0;
  bool enough = true;
  for (const Sample g : groups) {
    if (g.empty()) return std::nullopt;
    enough = enough && g.size() >= kEnoughAlike;
    n += count(g);
    sum += meanOf(g) * count(g);
  }
  const double between = static_cast<double>(groups.size()) - 1, within = n - static_cast<double>(groups.size());
  if (between < 1 || within < 1) return std::nullopt;
  double squaresBetween = 0, squaresWithin = 0;
  for (const Sample g : groups) {
    const double distance = meanOf(g) - sum / n;
    squaresBetween += count(g) * distance * distance;
    squaresWithin += varianceOf(g) * (count(g) - 1);
  }
  if (squaresWithin == 0 && !enough) return std::nullopt;
  const double f = (squaresBetween / between) / (squaresWithin / within);
  return TestResult{f, between, within, tailOfF(f, between, within)};
}

std::optional<TestResult> anovaOfTwo(Sample a, Sample b) {
  return a.size() < 2 || b.size() < 2 ? std::nullopt : oneWayAnova({a, b});
}

std::optional<TestResult> welchTest(Sample a, Sample b) {
  if (!scatters(a) || !scatters(b)) return std::nullopt;
  const double squaredError = squaredStandardErrors(a, b).sum();
  if (squaredError == 0) return TestResult{0.0, 0.0, 0.0, meanOf(a) == meanOf(b) ? 1.0 : 0.0};
  const double t = (meanOf(b) - meanOf(a)) / std::sqrt(squaredError);
  const double degrees = welchDegrees(a, b);
  return TestResult{t, degrees, 0.0, twoTailsOfT(t, degrees)};
}

std::optional<Interval> differenceInterval(Sample a, Sample b) {
  if (!scatters(a) || !scatters(b)) return std::nullopt;
  const double difference = meanOf(b) - meanOf(a);
  const double squaredError = squaredStandardErrors(a, b).sum();
  if (squaredError == 0) return Interval{difference, difference, difference};
  const double half = tQuantile(welchDegrees(a, b)) * std::sqrt(squaredError);
  return Interval{difference, difference - half, difference + half};
}

std::optional<TestResult> pairedTest(Sample a, Sample b) {
  expects(a.size() == b.size(), "pairs have two values each");
  std::vector<double> differences(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) differences[i] = b[i] - a[i];
  if (!scatters(differences)) return std::nullopt;
  const double t = meanOf(differences) / std::sqrt(varianceOf(differences) / count(a));
  return TestResult{t, count(a) - 1, 0.0, twoTailsOfT(t, count(a) - 1)};
}

std::optional<TestResult> brownForsytheTest(const std::vector<Sample>& groups) {
  std::vector<std::vector<double>> distances;
  for (const Sample g : groups) {
    if (g.empty()) return std::nullopt;
    const double median = medianOf(g);
    distances.emplace_back();
    for (const double v : g) distances.back().push_back(std::abs(v - median));
  }
  return oneWayAnova({distances.begin(), distances.end()});
}

// The transformations of skewness (D'Agostino 1970) and of kurtosis (Anscombe & Glynn 1983) to normal deviates.
std::optional<TestResult> normalityTest(Sample x) {
  const double n = count(x), mean = x.empty() ? 0.0 : meanOf(x);
  if (n < 20) return std::nullopt;
  double m2 = 0, m3 = 0, m4 = 0;
  for (const double v : x) {
    const double d = v - mean;
    m2 += d * d / n, m3 += d * d * d / n, m4 += d * d * d * d / n;
  }
  if (m2 == 0.0) return std::nullopt;

  const double y = m3 / std::pow(m2, 1.5) * std::sqrt((n + 1) * (n + 3) / (6 * (n - 2)));
  const double beta2 = 3 * (n * n + 27 * n - 70) * (n + 1) * (n + 3) / ((n - 2) * (n + 5) * (n + 7) * (n + 9));
  const double w2 = std::sqrt(2 * (beta2 - 1)) - 1;
  const double skewness = std::asinh(y / std::sqrt(2 / (w2 - 1))) / std::sqrt(0.5 * std::log(w2));

  const double expected = 3 * (n - 1) / (n + 1);
  const double variance = 24 * n * (n - 2) * (n - 3) / ((n + 1) * (n + 1) * (n + 3) * (n + 5));
  const double z = (m4 / (m2 * m2) - expected) / std::sqrt(variance);
  const double beta1 =
      6 * (n * n - 5 * n + 2) / ((n + 7) * (n + 9)) * std::sqrt(6 * (n + 3) * (n + 5) / (n * (n - 2) * (n - 3)));
  const double a = 6 + 8 / beta1 * (2 / beta1 + std::sqrt(1 + 4 / (beta1 * beta1)));
  const double kurtosis =
      (1 - 2 / (9 * a) - std::cbrt((1 - 2 / a) / (1 + z * std::sqrt(2 / (a - 4))))) / std::sqrt(2 / (9 * a));

  const double k2 = skewness * skewness + kurtosis * kurtosis;
  return TestResult{k2, 2.0, 0.0, dist::cdf(dist::complement(dist::chi_squared(2), k2))};
}

std::vector<double> holm(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return p[i] < p[j]; });
  std::vector<double> adjusted(p.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    largest = std::max(largest, std::min(1.0, p[order[i]] * static_cast<double>(p.size() - i)));
    adjusted[order[i]] = largest;
  }
  return adjusted;
}

std::optional<double> effectSize(Sample a, Sample b) {
  const double degrees = count(a) + count(b) - 2;
  if (a.size() < 2 || b.size() < 2) return std::nullopt;
  const double pooled = std::sqrt(((count(a) - 1) * varianceOf(a) + (count(b) - 1) * varianceOf(b)) / degrees);
  if (pooled == 0.0) return std::nullopt;
  return (meanOf(b) - meanOf(a)) / pooled * (1 - 3 / (4 * degrees - 1));
}

std::optional<double> rankCorrelation(Sample a, Sample b) {
  expects(a.size() == b.size(), "pairs have two values each");
  if (a.size() < 2) return std::nullopt;
  const auto ra = ranksOf(a), rb = ranksOf(b);
  const double middle = (count(a) + 1) / 2;
  double products = 0, squaresA = 0, squaresB = 0;
  for (std::size_t i = 0; i < ra.size(); ++i) {
    products += (ra[i] - middle) * (rb[i] - middle);
    squaresA += (ra[i] - middle) * (ra[i] - middle);
    squaresB += (rb[i] - middle) * (rb[i] - middle);
  }
  if (squaresA == 0.0 || squaresB == 0.0) return std::nullopt;
  return products / std::sqrt(squaresA * squaresB);
}

namespace {

/// times·(z_level + z_power)² σ²/Δ² + correction·z_level²
std::int64_t needed(double times, double correction, double sd, double difference, double power, double level) {
  constexpr double kMost = 1e6;
  if (difference == 0.0) return static_cast<std::int64_t>(kMost);
  const dist::normal normal;
  const double z = dist::quantile(normal, 1 - level / 2), ratio = (z + dist::quantile(normal, power)) * sd / difference;
  return static_cast<std::int64_t>(std::clamp(std::ceil(times * ratio * ratio + correction * z * z), 2.0, kMost));
}

}  // namespace

std::int64_t livesNeeded(double standardDeviation, double difference, double power, double level) {
  return needed(2, 0.25, standardDeviation, difference, power, level);
}

std::int64_t pairsNeeded(double standardDeviation, double difference, double power, double level) {
  return needed(1, 0.5, standardDeviation, difference, power, level);
}

// share = σ²_between/(σ²_between + σ²_within), σ²_between = (MS_between − MS_within)/n, n the size of a group (for
// unequal ones n₀ = (N − Σ n_i²/N)/(k − 1))
std::optional<VarianceComponent> varianceComponent(const std::vector<Sample>& groups) {
  const auto test = oneWayAnova(groups);
  if (!test) return std::nullopt;
  double n = 0, squares = 0, within = 0;
  for (const Sample g : groups) {
    n += count(g);
    squares += count(g) * count(g);
    within += varianceOf(g) * (count(g) - 1);
  }
  within /= test->degrees2;
  const double size = (n - squares / n) / test->degrees1;
  if (within == 0.0) return VarianceComponent{*test, test->p < 0.5 ? 1.0 : 0.0};
  const double between = std::max(0.0, (test->statistic - 1) * within / size);
  return VarianceComponent{*test, between / (between + within)};
}

double changeInPerCent(double before, double after) {
  if (before == after) return 0.0;
  return before == 0 ? std::numeric_limits<double>::quiet_NaN() : 100.0 * (after - before) / std::abs(before);
}

double quantileOfSorted(Sample sorted, double q) {
  expects(!sorted.empty(), "no value has no quantile");
  const double place = q * (count(sorted) - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double part = place - static_cast<double>(below);
  return part == 0.0 ? sorted[below] : sorted[below] + part * (sorted[above] - sorted[below]);
}

}  // namespace surefoot
