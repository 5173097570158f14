// SPDX-License-Identifier: GPL-3.0-or-later
// What one estimate learned in its last step, for those who want it explained.
#pragma once

#include <string>

namespace surefoot {

/// δ = reward + next − before (Sutton & Barto 2018, section 12.7).
struct LearnedStep {
  double reward = 0.0;
  double next = 0.0;    ///< γ times the value of what follows, before the update; 0 after a terminal outcome
  double before = 0.0;  ///< q̂(S, A) before it
  double delta() const { return reward + next - before; }
};

/// Of an agent's estimate: "q", "positive", "negative".
struct NamedStep {
  std::string name;
  LearnedStep step;
  double stepSize = 0.0;    ///< α
  double traceDecay = 0.0;  ///< λ
};

}  // namespace surefoot
