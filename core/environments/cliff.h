// SPDX-License-Identifier: GPL-3.0-or-later
// Cliff walking (Sutton & Barto 2018, example 6.6; the thesis's Figure 2.1): a grid of 4 × 12. From the lower left
// corner to the lower right one; between them lies the cliff. Every step costs 1; a step into the cliff costs 100 and
// leads back to the start, without ending the episode. State: column, and row from 0 at the bottom. Actions: up, down,
// left, right. No clock.
#pragma once

#include "core/environments/grid.h"
#include "core/environments/small_world.h"

namespace surefoot {

class Cliff final : public SmallWorld<2> {
 public:
  static constexpr Grid kGrid{.columns = 12, .rows = 4};

  Cliff();
  void reset(Random& random) override;
  Outcome step(Action action) override;
  void draw(std::span<const double> pose, Scene& scene) const override;
  std::vector<ReadOut> readOuts(std::span<const double> pose) const override;
};

}  // namespace surefoot
