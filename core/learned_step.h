// SPDX-License-Identifier: GPL-3.0-or-later
// The last learning step of one estimate, to explain it to the user.
#pragma once

#include <string>
#include <vector>

#include "core/basics/types.h"

namespace surefoot {

/// δ = reward + next − before (Sutton & Barto 2018, section 12.7).
struct LearnedStep {
  double reward = 0.0;
  double next = 0.0;    ///< γ times the next state's value, before the update; 0 after a terminal outcome
  double before = 0.0;  ///< q̂(S, A) before the update
  double delta() const { return reward + next - before; }
};

/// What was done in that step.
struct StepTaken {
  std::vector<double> state{};  ///< S; empty: no step is known
  Action action = kNoAction;    ///< A
};

/// The last step of an agent's estimate with its name: "q", "positive", "negative".
struct NamedStep {
  std::string name;
  LearnedStep step;
  double stepSize = 0.0;    ///< α
  double traceDecay = 0.0;  ///< λ
};

}  // namespace surefoot
