// SPDX-License-Identifier: GPL-3.0-or-later
// A hand that holds the body by a spring with a damper: pushes towards a point, one a step. Ours; the spring is as
// stiff as the pendulum's pole needs to be held against gravity.
#pragma once

#include <algorithm>
#include <optional>

#include "core/environment.h"

namespace surefoot {

class Hand {
 public:
  /// Where the body's tip is pulled to, horizontally [m]; nothing lets go.
  void hold(std::optional<double> target) {
    target_ = target;
    if (!target) before_.reset();
  }
  bool holds() const { return target_.has_value(); }
  /// The impulse [N s] for one step of `seconds`.
  double impulse(const Environment& environment, double seconds) {
    Scene scene;
    environment.draw(environment.pose(), scene);
    const double speed = before_ && seconds > 0 ? (scene.tip.x - *before_) / seconds : 0.0;
    before_ = scene.tip.x;
    const double force = kStiffness * (target_.value_or(scene.tip.x) - scene.tip.x) - kDamping * speed;
    return std::clamp(force, -kMostForce, kMostForce) * seconds;
  }

 private:
  static constexpr double kStiffness = 300.0, kDamping = 8.0, kMostForce = 40.0;  // [N/m], [N s/m], [N]
  std::optional<double> target_, before_;
};

}  // namespace surefoot
