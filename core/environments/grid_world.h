// SPDX-License-Identifier: GPL-3.0-or-later
// A grid with a bad region (after the thesis's Figure 6.1, which shows how a coarse value function warns of it and a
// fine one does not; the thesis gives no sizes, these are ours): 10 × 10 cells, 3 × 4 of them in the middle are a fall,
// which ends the episode with −100. From the lower left corner to the upper right one, which is worth 100. No clock.
#pragma once

#include "core/environments/grid.h"
#include "core/environments/small_world.h"

namespace surefoot {

class GridWorld final : public SmallWorld<2> {
 public:
  static constexpr Grid kGrid{.columns = 10, .rows = 10};
  /// The bad region, both ends included.
  static constexpr int kBadLeft = 4, kBadRight = 6, kBadBottom = 3, kBadTop = 6;

  GridWorld();
  void reset(Random& random) override;
  void resetTo(double column, double row);
  Outcome step(Action action) override;
  void draw(std::span<const double> pose, Scene& scene) const override;
  std::vector<ReadOut> readOuts(std::span<const double> pose) const override;
};

}  // namespace surefoot
