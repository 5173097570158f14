// SPDX-License-Identifier: GPL-3.0-or-later
// The course of a life in a bounded number of points, however long it lasts.
#pragma once

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

/// Keeps the state after each of the first kAll episodes, where most is learned, and after every k-th one behind them.
/// When kMostPoints are reached every second of those goes and k doubles.
class LearningCurve {
 public:
  static constexpr std::size_t kMostPoints = 2048;
  static constexpr std::int64_t kAll = 512;

  LearningCurve() { points_.reserve(kMostPoints); }
  void add(const EpisodeRow& row, std::int64_t falls) {
    if (!keeps(row.episode)) return;
    points_.push_back({row.episode, row.lifeSteps, falls, row.averageReward});
    if (points_.size() < kMostPoints) return;
    every_ *= 2;
    std::erase_if(points_, [this](const CurvePoint& p) { return !keeps(p.episode); });
  }
  const std::vector<CurvePoint>& points() const { return points_; }

 private:
  bool keeps(std::int64_t episode) const { return episode <= kAll || episode % every_ == 0; }

  std::int64_t every_ = 1;
  std::vector<CurvePoint> points_;
};

}  // namespace surefoot
