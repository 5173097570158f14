// SPDX-License-Identifier: GPL-3.0-or-later
// Mountain car (Sutton & Barto 2018, example 10.1): a car too weak for the slope must swing to gain height.
//   ẋ ← bound[ẋ + 0.001·a − 0.0025·cos 3x],  x ← bound[x + ẋ],  x in −1.2 … 0.5, ẋ in ± 0.07
// At the left bound ẋ becomes 0; at the right one the episode ends. Every step costs 1. Starts: x uniform in [−0.6,
// −0.4), at rest. Actions: full throttle reverse, none, forward. No clock.
#pragma once

#include "core/environments/small_world.h"

namespace surefoot {

class MountainCar final : public SmallWorld<2> {
 public:
  static constexpr double kLeft = -1.2, kGoal = 0.5, kFastest = 0.07;

  MountainCar();
  void reset(Random& random) override;
  void resetTo(double position, double velocity);
  Outcome step(Action action) override;
  void draw(std::span<const double> pose, Scene& scene) const override;
  std::vector<ReadOut> readOuts(std::span<const double> pose) const override;
};

}  // namespace surefoot
