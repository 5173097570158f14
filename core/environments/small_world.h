// SPDX-License-Identifier: GPL-3.0-or-later
// What worlds share that are written as equations or tables: their state is all there is to them, nothing but the step
// limit can be set, and an episode that reaches it is cut off.
#pragma once

#include <array>

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

 protected:
  Task task_;
  StepLimit limit_;
  std::array<double, kVariables> state_{};
};

}  // namespace surefoot
