// SPDX-License-Identifier: GPL-3.0-or-later
// The greedy policy (thesis, eq. 2.1): a ← argmax_a Q(s, a); ties share the probability equally.
#pragma once

#include "core/policy.h"

namespace surefoot {

class Greedy final : public Policy {
 protected:
  void declareRule(Fields&) override {}
  void among(std::span<const double> q, std::span<double> pi) const override { shareAmongGreedy(q, 1.0, pi); }
};

}  // namespace surefoot
