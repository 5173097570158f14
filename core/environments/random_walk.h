// SPDX-License-Identifier: GPL-3.0-or-later
// The random walk of 19 states (Sutton & Barto 2018, example 7.1 and Figure 12.6): from the middle, a step to the left
// or to the right with equal chances, until one end is passed: −1 on the left, +1 on the right. One action, so that
// only values are learned; those of the states 1 … 19 are (i − 10)/10. No clock.
#pragma once

#include "core/environments/corridor.h"
#include "core/environments/small_world.h"

namespace surefoot {

class RandomWalk final : public SmallWorld<1> {
 public:
  static constexpr int kStates = 19;

  RandomWalk();
  void reset(Random& random) override;
  Outcome step(Action action) override;
  void draw(std::span<const double> pose, Scene& scene) const override;
  std::vector<ReadOut> readOuts(std::span<const double> pose) const override { return {{"state", "", pose[0], 0}}; }

  /// The true value of state 1 … 19 for γ = 1.
  static double value(double state) { return (state - 10.0) / 10.0; }

 private:
  Random way_{0};  // generator of this episode
};

}  // namespace surefoot
