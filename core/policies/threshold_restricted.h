// SPDX-License-Identifier: GPL-3.0-or-later
// Threshold Restricted Learning (thesis, section 4.1, Algorithm 1): explores among the actions whose value is above a
// threshold, and below it only with a small probability.
//
//   A⁺ = {a : Q(s, a) > threshold},  p = probability below, of exploratory steps
//   π  = (1 − ε)·greedy + ε·[(1 − p)/abs(A⁺) in A⁺, p/(n − abs(A⁺)) outside];  A⁺ empty or all: ε/n, as ε-greedy
#pragma once

#include "core/policies/epsilon_greedy.h"
#include "core/policy.h"

namespace surefoot {

class ThresholdRestricted final : public Policy {
 public:
  struct Settings {
    Exploration exploration;
    Scheduled threshold{50.0};
    double below = 0.01;
    void declare(Fields& f);
  };

  ThresholdRestricted() = default;
  explicit ThresholdRestricted(const Settings& settings) : settings_(settings) {}

 protected:
  void declareRule(Fields& f) override { settings_.declare(f); }
  void advanceRule(const LifeTime& time) override {
    settings_.threshold.advance(time);
    settings_.exploration.epsilon.advance(time);
  }
  bool ruleChangesEveryStep() const override {
    return settings_.threshold.everyStep() || settings_.exploration.epsilon.everyStep();
  }
  void among(std::span<const double> q, std::span<double> pi) const override;

 private:
  Settings settings_;
};

}  // namespace surefoot
