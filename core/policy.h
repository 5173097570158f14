// SPDX-License-Identifier: GPL-3.0-or-later
// An action-selection rule: from the values of the actions to the probability of each.
#pragma once

#include <span>

#include "core/basics/random.h"
#include "core/basics/types.h"
#include "core/parameters.h"
#include "core/schedule.h"

namespace surefoot {

class Policy : public Scheduling {
 public:
  /// q̂(s, ·) → π(· | s). Both spans have one entry an action, 1 to kMaxActions; `q` is finite, `pi` sums to 1. Hot;
  /// any thread, as long as none changes the settings meanwhile.
  virtual void probabilities(std::span<const double> q, std::span<double> pi) const = 0;
};

/// Draws an action from π with one random number: the first a with u < π(0) + … + π(a).
inline Action sample(std::span<const double> pi, Random& random) {
  const double u = random.uniform();
  double sum = 0.0;
  Action last = 0;  // rounding may leave the whole sum a little below 1
  for (Action a = 0; a < static_cast<Action>(pi.size()); ++a) {
    const double p = pi[static_cast<std::size_t>(a)];
    if (p <= 0.0) continue;
    sum += p;
    last = a;
    if (u < sum) break;
  }
  return last;
}

}  // namespace surefoot
