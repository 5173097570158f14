// SPDX-License-Identifier: GPL-3.0-or-later
// ε-greedy (thesis, eq. 2.2; Sutton & Barto 2018, section 2.2): π = (1 − ε)·greedy + ε/n.
#pragma once

#include "core/policy.h"

namespace surefoot {

/// How often an exploratory step is taken. Shared by every policy that tells greedy from exploratory steps.
struct Exploration {
  Scheduled epsilon{0.05};
  void declare(Fields& f) {
    epsilon.declare(f, {.key = "epsilon",
                        .title = "Exploration",
                        .symbol = "ε",
                        .unit = "",
                        .low = 0.0,
                        .high = 1.0,
                        .sliderLow = 0.0,
                        .sliderHigh = 0.3,
                        .when = When::Now,
                        .group = Group::Policy,
                        .help = "Share of the steps that explore instead of taking the best action.",
                        .origin = "thesis, section 3.1.4"});
  }
};

class EpsilonGreedy final : public Policy {
 protected:
  void declareRule(Fields& f) override { exploration_.declare(f); }
  void advanceRule(const LifeTime& time) override { exploration_.epsilon.advance(time); }
  bool ruleChangesEveryStep() const override { return exploration_.epsilon.everyStep(); }
  void among(std::span<const double> q, std::span<double> pi) const override;

 private:
  Exploration exploration_;
};

}  // namespace surefoot
