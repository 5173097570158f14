// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/equal_share.h"

#include <algorithm>
#include <cmath>

namespace surefoot {

double epsilonFor(double share, std::size_t actions) {
  if (actions < 2) return 0.0;
  const auto n = static_cast<double>(actions);
  return std::min(1.0, share * n / (n - 1));
}

std::vector<ShareOfTemperature> sharesOfSoftmax(const Registry& registry, const Configuration& start,
                                                std::int64_t episodes, const std::atomic<bool>* interrupted) {
  constexpr double kLowest = 1.0 / 16, kHighest = 64;
  std::vector<ShareOfTemperature> rows;
  for (double temperature = kLowest; temperature <= kHighest; temperature *= 2) {
    Configuration c = start;
    c.names.policy = "softmax";
    c.episodes = episodes;
    if (!c.parameters.set("policy.temperature", temperature)) break;
    auto life = makeLife(registry, c, 0, false);
    if (!life) break;
    while (!(*life)->finished()) {
      if (interrupted && *interrupted) return rows;
      (*life)->step();
    }
    const double share = static_cast<double>((*life)->agent().explored()) / static_cast<double>((*life)->steps());
    rows.push_back({temperature, std::max(share, rows.empty() ? 0.0 : rows.back().share)});  // it never falls
  }
  return rows;
}

double temperatureFor(double share, const std::vector<ShareOfTemperature>& rows) {
  if (rows.empty() || share <= 0) return 0.0;
  const auto after = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.share >= share; });
  if (after == rows.begin()) return after->temperature * share / std::max(after->share, 1e-9);
  if (after == rows.end()) return rows.back().temperature;
  const auto before = std::prev(after);
  const double part = (share - before->share) / (after->share - before->share);
  return std::exp(std::log(before->temperature) + part * std::log(after->temperature / before->temperature));
}

}  // namespace surefoot
