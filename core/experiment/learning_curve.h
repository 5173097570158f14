// SPDX-License-Identifier: GPL-3.0-or-later
// The course of a life in a bounded number of points, however long it lasts.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/experiment/episode_log.h"

namespace surefoot {

struct CurvePoint {
  std::int64_t episode = 0;
  std::int64_t lifeSteps = 0;
  std::int64_t falls = 0;      ///< of the life so far
  double averageReward = 0.0;  ///< over the last 80 episodes
};

/// Keeps the state after every k-th episode. When kMostPoints are reached every second one goes and k doubles.
class LearningCurve {
 public:
  static constexpr std::size_t kMostPoints = 2048;

  LearningCurve() { points_.reserve(kMostPoints); }
  void add(const EpisodeRow& row, std::int64_t falls) {
    if (row.episode % every_ != 0) return;
    points_.push_back({row.episode, row.lifeSteps, falls, row.averageReward});
    if (points_.size() < kMostPoints) return;
    every_ *= 2;
    std::erase_if(points_, [this](const CurvePoint& p) { return p.episode % every_ != 0; });
  }
  const std::vector<CurvePoint>& points() const { return points_; }

 private:
  std::int64_t every_ = 1;
  std::vector<CurvePoint> points_;
};

/// When learning ended, by the thesis's rule for one life (section 4.2.1): the first episode k ≥ 330 at which the
/// average reward has moved by less than 3 in 250 episodes, and (ours: the flat start would count) is above 0.75 of the
/// best.
class EndOfLearning {
 public:
  void add(const EpisodeRow& row, double goalReward) {
    double& before = averages_[static_cast<std::size_t>(row.episode % kSpan)];
    const double change = row.averageReward - before;
    if (!episode_ && row.episode >= kFirst && change < kMost && change > -kMost &&
        row.averageReward > 0.75 * goalReward) {
      episode_ = row.episode;
      lifeSteps_ = row.lifeSteps;
    }
    before = row.averageReward;
  }
  std::int64_t episode() const { return episode_; }  ///< 0: not yet
  std::int64_t lifeSteps() const { return lifeSteps_; }

 private:
  static constexpr std::int64_t kFirst = 330, kSpan = 250;
  static constexpr double kMost = 3.0;
  std::array<double, kSpan> averages_{};
  std::int64_t episode_ = 0, lifeSteps_ = 0;
};

}  // namespace surefoot
