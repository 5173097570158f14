// SPDX-License-Identifier: GPL-3.0-or-later
// Mellowmax selection (Asadi & Littman 2017, arXiv 1612.05628, section 5): of all π whose expected value is
//
//   mm_ω(q) = ln(1/n Σ_a exp(ω q(a)))/ω,
//
// the one with the largest entropy. It is a Softmax, π(a) ∝ exp(β q(a)), whose β belongs to the state: the root of
//
//   Σ_a exp(β (q(a) − mm)) (q(a) − mm) = 0,   β ≥ 0.
//
// Its mean over the actions is a non-expansion, which that of Softmax is not. The sum grows with β, so that the root is
// bracketed by doubling and halved to the last bits: 60 to 130 sums over the actions a choice.
#pragma once

#include "core/policy.h"

namespace surefoot {

class Mellowmax final : public Policy {
 public:
  struct Settings {
    Scheduled omega{1.0};
    void declare(Fields& f) {
      omega.declare(f, {.key = "omega",
                        .title = "Mellowness",
                        .symbol = "ω",
                        .unit = "",
                        .low = 1e-6,
                        .high = 1e6,
                        .sliderLow = 0.01,
                        .sliderHigh = 10,
                        .when = When::Now,
                        .group = Group::Policy,
                        .help = "Low: nearly equal chances. High: nearly greedy.",
                        .origin = "ours",
                        .order = 2});
    }
  };

  Mellowmax() = default;
  explicit Mellowmax(const Settings& settings) : settings_(settings) {}

 protected:
  void declareRule(Fields& f) override { settings_.declare(f); }
  void advanceRule(const LifeTime& time) override { settings_.omega.advance(time); }
  bool ruleChangesEveryStep() const override { return settings_.omega.everyStep(); }
  void among(std::span<const double> q, std::span<double> pi) const override;

 private:
  Settings settings_;
};

}  // namespace surefoot
