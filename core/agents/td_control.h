// SPDX-License-Identifier: GPL-3.0-or-later
// Temporal-difference control with one estimate (Sutton & Barto 2018, chapters 6, 10 and 12): Sarsa(λ), Watkins's Q(λ)
// and Expected Sarsa(λ), which differ in their target only.
#pragma once

#include <type_traits>
#include <utility>

#include "core/agent.h"
#include "core/agents/targets.h"
#include "core/values/estimate.h"

namespace surefoot {

/// Settings of every learning rule, besides its estimates.
struct ControlSettings {
  double discount = 0.98;  ///< γ
  TraceSettings traces;
  bool dutch = false;  ///< true online: of the traces' settings only the cut-off has a meaning
  void declare(Fields& f);
};

template <class Target, FeatureMap F>
class TdControl final : public Agent {
 public:
  TdControl(Estimate<F> estimate, const ControlSettings& control) : estimate_(std::move(estimate)), control_(control) {
    q_.resize(static_cast<std::size_t>(estimate_.values().actions()));
    pi_.resize(q_.size());
  }

  void declare(Fields& f) override {
    estimate_.settings().declare(f);
    control_.declare(f);
  }

  Action start(std::span<const double> state, Random& random) override {
    startUnguarded();
    a_ = choose(state, random);
    old_ = 0.0;
    estimate_.go();
    return a_;
  }

  Action step(const Outcome& outcome, std::span<const double> state, Random& random) override {
    const Action next = choose(state, random);
    learn(outcome.reward, Target::value(q_, pi_, next));
    if (Target::cutsTrace(q_, next)) estimate_.clearTrace();
    estimate_.go();
    return a_ = next;
  }

  void end(const Outcome& outcome) override {
    learn(outcome.reward, 0.0);
    estimate_.clearTrace();
  }

  Action truncate(const Outcome& outcome, std::span<const double> state, Random& random) override {
    const Action next = choose(state, random);
    learn(outcome.reward, Target::value(q_, pi_, next));
    estimate_.clearTrace();
    return next;
  }

  void abandon() override { estimate_.clearTrace(); }

  const ActionValueFunction& values() const override { return estimate_.values(); }
  void eligibility(std::vector<Eligibility>& z) const override {
    z.clear();
    estimate_.eligibility(z, 0);
  }
  std::vector<NamedStep> lastSteps() const override { return {estimate_.lastStep("q")}; }
  bool diverged() const override { return estimate_.diverged(); }
  std::int64_t statesOutside() const override { return estimate_.statesOutside(); }

  void advance(const LifeTime& time) override { estimate_.settings().stepSize.advance(time); }
  bool everyStep() const override { return estimate_.settings().stepSize.everyStep(); }
  Json layouts() const override { return {{"q", estimate_.values().features().layout()}}; }
  void fit(std::span<const double> state, Layer, std::span<const double> q, double share, double visits) override {
    estimate_.values().fit(state, q, share, visits);
  }
  void transferValues(Archive& archive) override {
    archive.under("q.", [&] { estimate_.values().transfer(archive); });
  }
  void transferLearning(Archive& archive) override {
    archive.value("action", a_, 0, static_cast<int>(q_.size()) - 1);
    transferChosen(archive);
    if constexpr (kTrueOnline) archive.value("old", old_);
    archive.under("q.", [&] { estimate_.transferLearning(archive); });
  }

 private:
  static constexpr bool kTrueOnline = std::is_same_v<Target, TrueOnlineTarget>;

  /// A′ ~ π(·|S′); leaves q̂(S′, ·) in q_ and π(·|S′) in pi_.
  Action choose(std::span<const double> state, Random& random) {
    estimate_.arrive(state, q_);
    return draw({state, q_}, pi_, random);
  }

  /// `next` is the value of S′.
  void learn(double reward, double next) {
    const double gamma = control_.discount;
    if constexpr (kTrueOnline)
      estimate_.learnTrueOnline(a_, reward, gamma * next, old_, gamma, control_.traces.cutoff), old_ = next;
    else
      estimate_.learn(a_, reward, gamma * next, gamma, control_.traces);
  }

  Estimate<F> estimate_;
  ControlSettings control_;
  std::vector<double> q_, pi_;  // one entry an action
  Action a_ = 0;
  double old_ = 0.0;  // true online: q̂(S, A) before the update in which it was the next value
};

}  // namespace surefoot
