// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by worlds that are equations or tables: the state describes them completely, their only setting is the step
// limit, and an episode that reaches it is cut off.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/environment.h"
#include "core/environments/step_limit.h"

namespace surefoot {

template <std::size_t kVariables>
class SmallWorld : public Environment {
 public:
  void declare(Fields& f) override { limit_.declare(f); }
  const Task& task() const override { return task_; }
  std::span<const double> state() const override { return state_; }
  std::vector<double> pose() const override { return {state_.begin(), state_.end()}; }
  std::vector<double> poseAt(std::span<const double> state) const override { return rounded(state); }
  bool place(std::span<const double> state) override {
    const auto to = rounded(state);
    std::copy(to.begin(), to.end(), state_.begin());
    limit_.steps = 0;
    return true;
  }

 private:
  /// Whole numbers where the variable takes no others.
  std::vector<double> rounded(std::span<const double> state) const {
    std::vector<double> to(state.begin(), state.end());
    for (std::size_t d = 0; d < to.size(); ++d)
      if (task_.state[d].whole) to[d] = std::round(to[d]);
    return to;
  }

 protected:
  Task task_;
  StepLimit limit_;
  std::array<double, kVariables> state_{};
};

}  // namespace surefoot
