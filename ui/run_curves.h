// SPDX-License-Identifier: GPL-3.0-or-later
// The learning curves that the charts draw: the life that runs, and the last few before it.
#pragma once

#include <string>
#include <vector>

#include "core/experiment/learning_curve.h"

namespace surefoot {

struct RunCurve {
  std::string policy;
  std::vector<CurvePoint> points;
};

class RunCurves {
 public:
  static constexpr std::size_t kMostEarlier = 5;

  /// The points of the life that runs, and the policy of its last episode.
  void update(const std::string& policy, const std::vector<CurvePoint>& points) { live_ = {policy, points}; }
  /// The life that ran becomes an earlier one; one too short to say anything is forgotten.
  void archive();

  const RunCurve& live() const { return live_; }
  const std::vector<RunCurve>& earlier() const { return earlier_; }

 private:
  RunCurve live_;
  std::vector<RunCurve> earlier_;
};

}  // namespace surefoot
