// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run_curves.h"

namespace surefoot {

namespace {
constexpr std::int64_t kLeastEpisodes = 20;
}

void RunCurves::archive() {
  if (!live_.points.empty() && live_.points.back().episode >= kLeastEpisodes) {
    earlier_.push_back(std::move(live_));
    if (earlier_.size() > kMostEarlier) earlier_.erase(earlier_.begin());
  }
  live_ = {};
}

}  // namespace surefoot
