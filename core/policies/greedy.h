// SPDX-License-Identifier: GPL-3.0-or-later
// The greedy policy (thesis, eq. 2.1): a ← argmax_a Q(s, a); ties share the probability equally.
#pragma once

#include "core/policy.h"

namespace surefoot {

/// π(a) ← share / (number of maximisers) for every maximiser of q, 0 for the others.
void shareAmongGreedy(std::span<const double> q, double share, std::span<double> pi);

class Greedy final : public Policy {
 public:
  void declare(Fields&) override {}
  void probabilities(std::span<const double> q, std::span<double> pi) const override { shareAmongGreedy(q, 1.0, pi); }
};

}  // namespace surefoot
