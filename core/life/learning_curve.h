// SPDX-License-Identifier: GPL-3.0-or-later
// The course of a life in a bounded number of points, however long it lasts.
#pragma once

#include <cstdint>
#include <vector>

#include "core/life/episode_log.h"

namespace surefoot {

struct CurvePoint {
  std::int64_t episode = 0;
  std::int64_t lifeSteps = 0;
  std::int64_t falls = 0;      ///< falls of the life so far
  double averageReward = 0.0;  ///< over the last 80 episodes
};

/// Keeps the state after each of the first episodes, where most is learned. Later states are merged into groups of
/// neighbours. The width of a group, in episodes and in steps, is less than 1/resolution() of the life up to it; its
/// first, lowest, highest and last states are kept. So a drawing of any span of the life has the minima, the maxima and
/// the falls of the whole log, within a pixel, if a pixel is at least 1/resolution() of the life up to it: this holds
/// for the whole life on any screen, and for magnified parts. When kMostPoints are reached, the resolution is halved:
/// it is kFinest up to that many episodes and some 2,000 after 10^8. Used by one thread at a time; add() does not
/// allocate.
class LearningCurve {
 public:
  static constexpr std::size_t kMostPoints = 100'000;
  static constexpr std::int64_t kFinest = 16'384;

  LearningCurve() { points_.reserve(kMostPoints); }
  void add(const EpisodeRow& row, std::int64_t falls) {
    add(CurvePoint{row.episode, row.lifeSteps, falls, row.averageReward});
  }
  /// The life's state after its newest episode.
  void add(const CurvePoint& point);
  /// All points in the order of the life, the newest state at the end.
  void copyTo(std::vector<CurvePoint>& points) const;
  std::int64_t resolution() const { return resolution_; }

 private:
  /// Neighbouring states that are drawn as one.
  struct Group {
    CurvePoint first, least, greatest, last;
    /// Gives its different states to `put`, in their order: never more than went in.
    template <class Put>
    void each(const Put& put) const;
  };
  bool belongs(const CurvePoint& point) const;
  /// Adds the point to the open group, or begins a new group; then `put` gets the points of the old one.
  template <class Put>
  void take(const CurvePoint& point, const Put& put);
  void merge();

  std::int64_t resolution_ = kFinest;
  Group open_;  // empty: its episode is 0
  std::vector<CurvePoint> points_;
};

}  // namespace surefoot
