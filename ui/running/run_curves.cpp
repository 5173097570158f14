// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/running/run_curves.h"

#include <algorithm>

namespace surefoot {

namespace {

constexpr std::int64_t kLeastEpisodes = 20;

/// Where the curve stands at a step between two of its points.
CurvePoint between(const CurvePoint& a, const CurvePoint& b, std::int64_t step) {
  const double share = static_cast<double>(step - a.lifeSteps) / static_cast<double>(b.lifeSteps - a.lifeSteps);
  const auto episodes = static_cast<std::int64_t>(share * static_cast<double>(b.episode - a.episode));
  return {a.episode + episodes, step, a.falls, a.averageReward + share * (b.averageReward - a.averageReward)};
}

}  // namespace

void RunCurves::update(const std::string& agent, const std::string& policy, const std::vector<CurvePoint>& own,
                       const std::vector<Change>& changes) {
  std::vector<CurvePoint> points;
  for (const CurvePoint& point : before_)
    if (!own.empty() && point.episode < own.front().episode) points.push_back(point);
  points.insert(points.end(), own.begin(), own.end());
  live_ = {agent, live_.number, environment_, points, {}, 0, began_};
  if (points.empty()) return;
  // A life that was lived elsewhere before: when it fell then is not known.
  if (points.front().episode > 1) live_.fallsBefore = points.front().falls;
  std::vector<Change> switches;
  for (const Change& change : changes)
    if (change.key == "policy" && change.step < points.back().lifeSteps) switches.push_back(change);
  auto next = switches.begin();
  live_.pieces.push_back({switches.empty() ? policy : switches.front().before, {}, 0});
  for (const CurvePoint& point : points) {
    for (; next != switches.end() && next->step < point.lifeSteps; ++next) {
      CurvePiece piece{next->after, {}, next->step};
      std::vector<CurvePoint>& before = live_.pieces.back().points;
      if (!before.empty()) {
        before.push_back(between(before.back(), point, next->step));
        piece.points.push_back(before.back());
      }
      live_.pieces.push_back(std::move(piece));
    }
    live_.pieces.back().points.push_back(point);
  }
}

void RunCurves::archive() {
  before_.clear();
  if (!live_.points.empty() && live_.points.back().episode >= kLeastEpisodes) {
    earlier_.push_back(std::move(live_));
    if (earlier_.size() > kMostEarlier) earlier_.erase(earlier_.begin());
  }
  live_ = {};
  live_.number = ++newest_;
}

void RunCurves::bringBack(int number) {
  before_.clear();
  if (live_.number == number) return;
  live_ = {};
  live_.number = number;
  const auto found = std::find_if(earlier_.begin(), earlier_.end(), [&](const auto& c) { return c.number == number; });
  if (found == earlier_.end()) return;
  live_ = std::move(*found);
  earlier_.erase(found);
}

void RunCurves::forget() {
  before_.clear();
  earlier_.clear();
  live_ = {};
  newest_ = live_.number;
  ++environment_;
}

std::vector<RunCurve> RunCurves::remove(const std::vector<int>& numbers) {
  std::vector<RunCurve> removed, left;
  for (RunCurve& curve : earlier_) {
    const bool goes = std::find(numbers.begin(), numbers.end(), curve.number) != numbers.end();
    (goes ? removed : left).push_back(std::move(curve));
  }
  earlier_ = std::move(left);
  return removed;
}

void RunCurves::putBack(const std::vector<RunCurve>& curves) {
  for (const RunCurve& curve : curves)
    if (curve.environment == environment_) earlier_.push_back(curve);
  std::sort(earlier_.begin(), earlier_.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
}

}  // namespace surefoot
