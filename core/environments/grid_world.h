// SPDX-License-Identifier: GPL-3.0-or-later
// A grid with a bad region (after the thesis's Figure 6.1, which shows how a coarse value function warns of it and a
// fine one does not; the thesis gives no sizes, these are ours): 10 × 10 cells, 3 × 4 of them in the middle are a fall,
// which ends the episode with −100. From the lower left corner to the upper right one, which is worth 100. No clock.
#pragma once

#include "core/environments/grid.h"
#include "core/environments/step_limit.h"

namespace surefoot {

class GridWorld final : public Environment {
 public:
  static constexpr Grid kGrid{.columns = 10, .rows = 10};
  /// The bad region, both ends included.
  static constexpr int kBadLeft = 4, kBadRight = 6, kBadBottom = 3, kBadTop = 6;

  GridWorld();
  void declare(Fields& f) override { limit_.declare(f); }
  const Task& task() const override { return task_; }
  void reset(Random& random) override;
  void resetTo(double column, double row);
  Outcome step(Action action) override;
  std::span<const double> state() const override { return state_; }
  std::vector<double> pose() const override { return {state_[0], state_[1]}; }
  void draw(std::span<const double> pose, Scene& scene) const override;
  std::vector<ReadOut> readOuts(std::span<const double> pose) const override;

 private:
  Task task_;
  StepLimit limit_;
  std::array<double, 2> state_{};
};

}  // namespace surefoot
