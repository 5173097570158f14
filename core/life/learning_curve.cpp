// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/learning_curve.h"

#include <utility>

namespace surefoot {

template <class Put>
void LearningCurve::Group::each(const Put& put) const {
  if (first.episode == 0) return;  // nothing in it
  const bool down = greatest.episode < least.episode;
  std::int64_t before = 0;
  for (const CurvePoint* point : {&first, down ? &greatest : &least, down ? &least : &greatest, &last})
    if (point->episode != std::exchange(before, point->episode)) put(*point);
}

bool LearningCurve::belongs(const CurvePoint& point) const {
  return open_.first.episode > 0 && (point.episode - open_.first.episode) * resolution_ < point.episode &&
         (point.lifeSteps - open_.first.lifeSteps) * resolution_ < point.lifeSteps;
}

template <class Put>
void LearningCurve::take(const CurvePoint& point, const Put& put) {
  if (belongs(point)) {
    if (point.averageReward < open_.least.averageReward) open_.least = point;
    if (point.averageReward > open_.greatest.averageReward) open_.greatest = point;
    open_.last = point;
    return;
  }
  open_.each(put);
  open_ = {point, point, point, point};
}

void LearningCurve::add(const CurvePoint& point) {
  take(point, [this](const CurvePoint& p) { points_.push_back(p); });
  if (points_.size() + 4 > kMostPoints) merge();
}

/// The kept points are merged like episodes; this works in place, because merging never makes a group larger.
void LearningCurve::merge() {
  resolution_ /= 2;
  const Group newest = std::exchange(open_, {});
  std::size_t kept = 0;
  const auto put = [&](const CurvePoint& p) { points_[kept++] = p; };
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const CurvePoint point = points_[i];
    take(point, put);
  }
  open_.each(put);
  points_.resize(kept);
  open_ = newest;
}

void LearningCurve::copyTo(std::vector<CurvePoint>& points) const {
  points.reserve(points_.size() + 4);
  points.assign(points_.begin(), points_.end());
  open_.each([&](const CurvePoint& p) { points.push_back(p); });
}

}  // namespace surefoot
