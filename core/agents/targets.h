// SPDX-License-Identifier: GPL-3.0-or-later
// Targets: the value of the next state for a learning rule, given q̂(S′, ·), π(·|S′) and the drawn action A′.
#pragma once

#include <algorithm>
#include <span>

#include "core/basics/types.h"

namespace surefoot {

/// Sarsa (thesis, eq. 2.5): q̂(S′, A′).
struct SarsaTarget {
  static double value(std::span<const double> q, std::span<const double>, Action next) {
    return q[static_cast<std::size_t>(next)];
  }
  static bool cutsTrace(std::span<const double>, Action) { return false; }
};

/// True online Sarsa(λ) (van Seijen et al. 2016, JMLR 17; Sutton & Barto 2018, section 12.7): the target of Sarsa, with
/// dutch traces and a correction of what the update before has changed (Estimate::learnTrueOnline).
struct TrueOnlineTarget : SarsaTarget {};

/// Q-learning (thesis, eq. 2.7), with Watkins's traces (Sutton & Barto 2018, section 12.10): max_b q̂(S′, b); the trace
/// is cut before an exploratory action. An action counts as greedy if its value is the greatest, however it was drawn.
struct WatkinsTarget {
  static double value(std::span<const double> q, std::span<const double>, Action) {
    return *std::max_element(q.begin(), q.end());
  }
  static bool cutsTrace(std::span<const double> q, Action next) {
    return q[static_cast<std::size_t>(next)] < *std::max_element(q.begin(), q.end());
  }
};

/// Expected Sarsa (Sutton & Barto 2018, section 6.6): Σ_b π(b|S′) q̂(S′, b). Traces are not cut.
struct ExpectedTarget {
  static double value(std::span<const double> q, std::span<const double> pi, Action) {
    double sum = 0.0;
    for (std::size_t b = 0; b < q.size(); ++b) sum += pi[b] * q[b];
    return sum;
  }
  static bool cutsTrace(std::span<const double>, Action) { return false; }
};

}  // namespace surefoot
