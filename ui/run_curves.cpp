// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run_curves.h"

namespace surefoot {

namespace {
constexpr std::int64_t kLeastEpisodes = 20;
}

void RunCurves::update(const std::string& agent, const std::string& policy, const std::vector<CurvePoint>& points,
                       const std::vector<Change>& changes) {
  live_ = {agent, live_.number, points, {}};
  live_.began = began_;
  if (points.empty()) return;
  std::vector<Change> switches;
  for (const Change& change : changes)
    if (change.key == "policy" && change.step < points.back().lifeSteps) switches.push_back(change);
  auto next = switches.begin();
  live_.pieces.push_back({switches.empty() ? policy : switches.front().before, {}});
  for (const CurvePoint& point : points) {
    for (; next != switches.end() && next->step < point.lifeSteps; ++next) {
      CurvePiece piece{next->after, {}};
      if (!live_.pieces.back().points.empty()) piece.points.push_back(live_.pieces.back().points.back());
      live_.pieces.push_back(std::move(piece));
    }
    live_.pieces.back().points.push_back(point);
  }
}

void RunCurves::archive() {
  const int number = live_.number;
  if (!live_.points.empty() && live_.points.back().episode >= kLeastEpisodes) {
    earlier_.push_back(std::move(live_));
    if (earlier_.size() > kMostEarlier) earlier_.erase(earlier_.begin());
  }
  live_ = {.agent = {}, .number = number + 1, .points = {}, .pieces = {}};
}

void RunCurves::forget() {
  earlier_.clear();
  live_ = {};
}

}  // namespace surefoot
