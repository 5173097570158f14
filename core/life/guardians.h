// SPDX-License-Identifier: GPL-3.0-or-later
// Those who can act for the policy in a life (policy.guardian): the environment's own controller, and the greedy policy
// of a Q-function that learns nothing more.
#pragma once

#include <algorithm>
#include <memory>

#include "core/agent.h"
#include "core/environment.h"

namespace surefoot {

/// Used by the thread of the life. The environment must outlive it.
class Guardians final : public Guardian {
 public:
  /// `teacher`: null: there is no such Q-function.
  Guardians(const Environment& environment, std::unique_ptr<Agent> teacher)
      : environment_(environment),
        teacher_(std::move(teacher)),
        q_(environment.task().actions.size()) {}

  bool hasTeacher() const { return teacher_ != nullptr; }
  /// The first of the actions that the Q-function values highest, or the controller's.
  Action act(GuardedBy who, std::span<const double> state) const override {
    if (who == GuardedBy::HandMade) return environment_.handMadeAction();
    teacher_->values().evaluate(state, Layer::Sum, q_);
    return static_cast<Action>(std::max_element(q_.begin(), q_.end()) - q_.begin());
  }

 private:
  const Environment& environment_;
  std::unique_ptr<Agent> teacher_;
  mutable std::vector<double> q_;  // q̂(s, ·) of the teacher
};

}  // namespace surefoot
