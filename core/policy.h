// SPDX-License-Identifier: GPL-3.0-or-later
// An action-selection rule: from the values of the actions to the probability of each. Every policy can be cautious
// (caution.h): then it chooses by other values, or among fewer actions.
#pragma once

#include <algorithm>
#include <span>

#include "core/basics/random.h"
#include "core/basics/types.h"
#include "core/caution.h"
#include "core/parameters.h"
#include "core/schedule.h"

namespace surefoot {

class Policy : public Scheduling {
 public:
  void declare(Fields& f) final {
    declareRule(f);
    caution_.declare(f);
  }
  void advance(const LifeTime& time) final {
    advanceRule(time);
    caution_.advance(time);
  }
  bool everyStep() const final { return ruleChangesEveryStep() || caution_.everyStep(); }

  /// q̂(s, ·) → π(· | s). All spans have one entry an action, 1 to kMaxActions; `q` is finite, `pi` sums to 1. Hot; any
  /// thread, as long as none changes the settings meanwhile.
  void probabilities(const ActionView& view, std::span<double> pi) const {
    if (!caution_.actsOn(view)) return among(view.q, pi);
    cautious(view, pi, &Policy::among);
  }
  /// π of the greedy policy under the same caution.
  void greedy(const ActionView& view, std::span<double> pi) const;
  /// An action, and whether it is not the best by what the policy chooses by.
  struct Drawn {
    Action action;
    bool explores;
  };
  /// Draws from π, which is left in `pi`. Hot.
  Drawn draw(const ActionView& view, std::span<double> pi, Random& random) const;
  const Caution& caution() const { return caution_; }

 protected:
  virtual void declareRule(Fields& f) = 0;
  virtual void advanceRule(const LifeTime&) {}
  virtual bool ruleChangesEveryStep() const { return false; }
  /// The rule itself: π from values, for as many actions as there are.
  virtual void among(std::span<const double> q, std::span<double> pi) const = 0;

 private:
  using Rule = void (Policy::*)(std::span<const double>, std::span<double>) const;
  void cautious(const ActionView& view, std::span<double> pi, Rule rule) const;
  void amongAllowed(std::span<const double> q, std::span<const double> worth, std::span<double> pi, Rule rule) const;
  Drawn drawCautiously(const ActionView& view, std::span<double> pi, Random& random) const;
  void amongBest(std::span<const double> q, std::span<double> pi) const;

  Caution caution_;
};

/// π(a) ← share / (number of maximisers) for every maximiser of q, 0 for the others.
void shareAmongGreedy(std::span<const double> q, double share, std::span<double> pi);

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

inline Policy::Drawn Policy::draw(const ActionView& view, std::span<double> pi, Random& random) const {
  if (caution_.actsOn(view)) return drawCautiously(view, pi, random);
  among(view.q, pi);
  const Action a = sample(pi, random);
  return {a, view.q[static_cast<std::size_t>(a)] < *std::max_element(view.q.begin(), view.q.end())};
}

}  // namespace surefoot
