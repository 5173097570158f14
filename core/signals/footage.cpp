// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signals/footage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace surefoot {

namespace {
constexpr double kSlack = 1e-6;  // [pictures]; sums of steps hit multiples of 1/30 s not quite
}  // namespace

std::int64_t filmFrames(double seconds) {
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(seconds * kFilmRate - kSlack)));
}

Footage cut(const Footage& footage, double from, double to, double speed) {
  Footage film;
  if (footage.poses.empty()) return film;
  const std::int64_t frames = filmFrames((to - from) / speed);
  const double last = static_cast<double>(footage.poses.size() - 1);
  for (std::int64_t i = 0; i < frames; ++i) {
    const double time = from + static_cast<double>(i) / kFilmRate * speed;
    const auto at = static_cast<std::size_t>(std::clamp(std::floor(time * footage.rate + kSlack), 0.0, last));
    film.poses.push_back(footage.poses[at]);
    film.falls.push_back(footage.falls[at]);
    film.rows.push_back(footage.rows[at]);
  }
  return film;
}

void FootageTaker::look(const Environment& environment, double time, bool fell, std::int64_t row) {
  take(time);
  row_ = row;
  pose_ = environment.pose();
  if (!fell) return;
  fallen_ = pose_;
  fallenUntil_ = time + kFallShown;
}

Footage FootageTaker::finish(double end) {
  take(std::max(end, fallenUntil_));
  return std::move(footage_);
}

void FootageTaker::take(double until) {
  if (pose_.empty()) return;
  for (;;) {
    const auto next = static_cast<double>(footage_.poses.size());
    if (next >= until * kFilmRate - kSlack) return;
    const bool falls = next < fallenUntil_ * kFilmRate - kSlack;
    footage_.poses.push_back(falls ? fallen_ : pose_);
    footage_.falls.push_back(falls);
    footage_.rows.push_back(row_);
  }
}

}  // namespace surefoot
