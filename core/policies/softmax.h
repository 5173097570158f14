// SPDX-License-Identifier: GPL-3.0-or-later
// Softmax action selection with the Gibbs distribution (thesis, eq. 2.3):
//
//   π(a) = exp(Q(s, a)/τ) / Σ_b exp(Q(s, b)/τ), computed as exp((Q − max Q)/τ), which cannot overflow: right for every
//   τ > 0 and any finite Q, where the thesis had to stop at τ = 0.5.
#pragma once

#include "core/policy.h"

namespace surefoot {

class Softmax final : public Policy {
 public:
  struct Settings {
    Scheduled temperature{1.0};
    void declare(Fields& f) {
      temperature.declare(f, {.key = "temperature",
                              .title = "Temperature",
                              .symbol = "τ",
                              .unit = "",
                              .low = 1e-6,
                              .high = 1e6,
                              .sliderLow = 0.1,
                              .sliderHigh = 10,
                              .when = When::Now,
                              .group = Group::Policy,
                              .help = "High: nearly equal chances. Low: nearly greedy.",
                              .origin = "thesis, chapter 5 (its best case)"});
    }
  };

  Softmax() = default;
  explicit Softmax(const Settings& settings) : settings_(settings) {}

 protected:
  void declareRule(Fields& f) override { settings_.declare(f); }
  void advanceRule(const LifeTime& time) override { settings_.temperature.advance(time); }
  bool ruleChangesEveryStep() const override { return settings_.temperature.everyStep(); }
  void among(std::span<const double> q, std::span<double> pi) const override;

 private:
  Settings settings_;
};

}  // namespace surefoot
