// SPDX-License-Identifier: GPL-3.0-or-later
// What a policy does with the risk of a fall. It chooses by values that caution has looked at:
//
//   off       q̂(s, a)
//   weight    q̂(s, a) − w ρ(s, a)
//   filter    q̂(s, a) where ρ(s, a) ≤ limit, else not at all; if no action is left: the least risky ones
//   explore   as filter, but the best actions by q̂ stay: only exploring steps avoid risk
//   losses    Q⁺(s, a) + k Q⁻(s, a), of a learner that keeps expected losses apart; it needs no ρ
//
// ρ is the probability of a fall (agents/risk.h; Geibel & Wysotzki 2005). An action that is not allowed has no part in
// π: the policy chooses among the others as if there were only these.
#pragma once

#include <span>

#include "core/schedule.h"

namespace surefoot {

/// What a policy chooses by, in one state: each has one entry an action.
struct ActionView {
  std::span<const double> q;         ///< q̂(s, ·)
  std::span<const double> risk{};    ///< ρ(s, ·); empty: it is not learned
  std::span<const double> losses{};  ///< Q⁻(s, ·); empty: q̂ is not split
};

enum class CautionRule : int { Off, Weight, Filter, Explore, Losses };

/// "weight"
const char* nameOf(CautionRule rule);

class Caution {
 public:
  void declare(Fields& f);
  void advance(const LifeTime& time);
  bool everyStep() const;

  CautionRule rule() const { return rule_; }
  /// Whether it changes anything: its rule is on, and what the rule needs is learned. Hot.
  bool actsOn(const ActionView& v) const {
    return rule_ == CautionRule::Losses ? !v.losses.empty() : rule_ != CautionRule::Off && !v.risk.empty();
  }
  /// Whether what the rule needs is there: ρ, or Q⁻ apart.
  Status check(bool hasRisk, bool split) const;
  /// worth ← what the policy chooses by; −∞ where an action is not allowed. At least one is. Hot.
  void weigh(const ActionView& v, std::span<double> worth) const;

 private:
  void allow(const ActionView& v, bool best, std::span<double> worth) const;

  CautionRule rule_ = CautionRule::Off;
  Scheduled weight_{3000.0}, limit_{0.02}, factor_{1.0};
};

}  // namespace surefoot
