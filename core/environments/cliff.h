// SPDX-License-Identifier: GPL-3.0-or-later
// Cliff walking (Sutton & Barto 2018, example 6.6; the thesis's Figure 2.1): a grid of 4 × 12. From the lower left
// corner to the lower right one; between them lies the cliff. Every step costs 1; a step into the cliff costs 100 and
// leads back to the start, without ending the episode. State: column, and row from 0 at the bottom. Actions: up, down,
// left, right. No clock.
#pragma once

#include <array>

#include "core/environments/grid.h"
#include "core/environments/step_limit.h"

namespace surefoot {

class Cliff final : public Environment {
 public:
  static constexpr Grid kGrid{.columns = 12, .rows = 4};

  Cliff();
  void declare(Fields& f) override { limit_.declare(f); }
  const Task& task() const override { return task_; }
  void reset(Random& random) override;
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
