// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <tuple>

#include "core/statistics/mean_estimate.h"

namespace surefoot {

namespace {

/// Marsaglia & Bray's (1964) polar method.
double normal(Random& random) {
  for (;;) {
    const double u = random.uniform(-1, 1), v = random.uniform(-1, 1), s = u * u + v * v;
    if (s > 0 && s < 1) return u * std::sqrt(-2 * std::log(s) / s);
  }
}

/// χ² by Marsaglia & Tsang (2000), from two degrees of freedom on.
double chiSquared(double degrees, Random& random) {
  if (degrees < 2) {
    const double z = normal(random);
    return z * z;
  }
  const double d = degrees / 2 - 1.0 / 3, c = 1 / std::sqrt(9 * d);
  for (;;) {
    const double z = normal(random), w = 1 + c * z, v = w * w * w;
    if (v <= 0) continue;
    const double u = 1 - random.uniform();
    if (std::log(u) < z * z / 2 + d * (1 - v + std::log(v))) return 2 * d * v;
  }
}

/// Means that are drawn with the same random numbers.
struct Cluster {
  std::vector<std::size_t> members;
  std::size_t deviations = 0;
  double degrees = 0;
};

std::vector<Cluster> clustersOf(const std::vector<MeanEstimate>& means, const std::vector<std::size_t>& together) {
  std::map<std::tuple<std::size_t, bool, std::size_t>, std::size_t> numbers;
  std::vector<Cluster> clusters;
  for (std::size_t i = 0; i < means.size(); ++i) {
    const std::size_t deviations = means[i].deviations.size();
    const auto [place, isNew] = numbers.try_emplace({together[i], means[i].resampled, deviations}, clusters.size());
    if (isNew) clusters.push_back({{}, deviations, means[i].degrees});
    Cluster& cluster = clusters[place->second];
    cluster.members.push_back(i);
    cluster.degrees = std::min(cluster.degrees, means[i].degrees);
  }
  return clusters;
}

/// Every difference of two means has an error that is known.
bool tellDifferences(const std::vector<MeanEstimate>& means, const Cluster& cluster) {
  if (cluster.degrees + 1 >= kEnoughAlike) return true;
  for (const std::size_t i : cluster.members)
    for (const std::size_t j : cluster.members)
      if (i < j && !tellsDifference(means[i], means[j])) return false;
  return true;
}

}  // namespace

// mean + T·Σ z_i·d_i with normal z_i and T = √(degrees/χ²): Student's t times the standard error, in several dimensions
// with the covariances of the deviations. For a mean alone one z is enough.
std::vector<double> drawMeans(const std::vector<MeanEstimate>& means, const std::vector<std::size_t>& together,
                              const std::function<double(const std::vector<double>&)>& f, Random& random, int count) {
  std::vector<double> results, drawn(means.size()), z;
  if (!std::all_of(means.begin(), means.end(), [](const MeanEstimate& m) { return m.known(); })) return results;
  const auto clusters = clustersOf(means, together);
  for (const Cluster& c : clusters)
    if (!tellDifferences(means, c)) return results;
  std::vector<double> errors;
  for (const MeanEstimate& m : means) errors.push_back(std::sqrt(m.squaredError()));
  for (int k = 0; k < count; ++k) {
    for (const Cluster& cluster : clusters) {
      const bool alone = cluster.members.size() == 1;
      z.resize(alone ? 1 : cluster.deviations);
      for (double& v : z) v = normal(random);
      const double t = std::sqrt(cluster.degrees / chiSquared(cluster.degrees, random));
      for (const std::size_t i : cluster.members) {
        double sum = alone ? z[0] * errors[i] : 0.0;
        for (std::size_t d = 0; !alone && d < z.size(); ++d) sum += z[d] * means[i].deviations[d];
        drawn[i] = means[i].value + t * sum;
      }
    }
    results.push_back(f(drawn));
  }
  return results;
}

}  // namespace surefoot
