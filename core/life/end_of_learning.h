// SPDX-License-Identifier: GPL-3.0-or-later
// When learning ended, by the thesis's rule for one life (section 4.2.1): the first episode k ≥ 330 at which the
// average reward has moved by less than 3 in 250 episodes, and (ours: the flat start would count) is above 0.75 of the
// best.
#pragma once

#include <array>
#include <cstdint>

#include "core/files/archive.h"

namespace surefoot {

/// More than any life has: a larger number in a file is damage.
inline constexpr std::int64_t kMostLifeSteps = 1'000'000'000'000'000;

class EndOfLearning {
 public:
  /// Adds the average reward after episode number `episode` (from 1), which ended after `lifeSteps` steps of the life.
  void add(std::int64_t episode, double averageReward, std::int64_t lifeSteps, double bestReturn) {
    double& before = averages_[static_cast<std::size_t>(episode % kSpan)];
    const double change = averageReward - before;
    if (!reached() && episode >= kFirst && change < kMost && change > -kMost && averageReward > 0.75 * bestReturn) {
      episode_ = episode;
      lifeSteps_ = lifeSteps;
    }
    before = averageReward;
  }
  bool reached() const { return episode_ > 0; }
  std::int64_t episode() const { return episode_; }  ///< 0: not yet
  std::int64_t lifeSteps() const { return lifeSteps_; }

  void transfer(Archive& archive) {
    archive.table("averages", averages_);
    archive.value("episode", episode_, 0, kMostLifeSteps);
    archive.value("steps", lifeSteps_, 0, kMostLifeSteps);
  }

 private:
  static constexpr std::int64_t kFirst = 330, kSpan = 250;
  static constexpr double kMost = 3.0;
  std::array<double, kSpan> averages_{};
  std::int64_t episode_ = 0, lifeSteps_ = 0;
};

}  // namespace surefoot
