// SPDX-License-Identifier: GPL-3.0-or-later
// A chain of ten states, the discrete system of the thesis's Figure 4.2, where three tilings of tiles three states wide
// carry what is learned about state 5 over to its neighbours. The thesis gives no task; ours: steps to the left and to
// the right from a random state between, until one of the ends: a fall (−100) in state 1, the goal (100) in state 10.
// No clock.
#pragma once

#include "core/environments/corridor.h"
#include "core/environments/small_world.h"

namespace surefoot {

class Chain final : public SmallWorld<1> {
 public:
  static constexpr int kStates = 10;

  Chain();
  void reset(Random& random) override;
  Outcome step(Action action) override;
  void draw(std::span<const double> pose, Scene& scene) const override;
  std::vector<ReadOut> readOuts(std::span<const double> pose) const override { return {{"state", "", pose[0], 0}}; }
};

}  // namespace surefoot
