// SPDX-License-Identifier: GPL-3.0-or-later
// Sarsa_2Q (thesis, section 6.1.2, eq. 6.1 to 6.4): expected gains in Q⁺, expected losses in Q⁻, each with its own
// resolution, number of tilings, α, λ and traces; γ is shared. Actions are chosen on Q = Q⁺ + Q⁻, by any policy.
//
//   δ⁺ = r⁺ + γ Q⁺(S′, A′) − Q⁺(S, A),   δ⁻ = r⁻ + γ Q⁻(S′, A′) − Q⁻(S, A)
#pragma once

#include <utility>

#include "core/agents/reward_split.h"
#include "core/agents/td_control.h"
#include "core/values/split_action_value.h"

namespace surefoot {

template <FeatureMap P, FeatureMap N>
class Sarsa2Q final : public Agent {
 public:
  Sarsa2Q(Estimate<P> positive, Estimate<N> negative, const ControlSettings& control, RewardSplit split)
      : positive_(std::move(positive)),
        negative_(std::move(negative)),
        sum_(positive_.values(), negative_.values()),
        control_(control),
        split_(std::move(split)) {
    q_.resize(static_cast<std::size_t>(positive_.values().actions()));
    for (auto* values : {&pi_, &qPositive_, &qNegative_}) values->resize(q_.size());
  }
  Sarsa2Q(const Sarsa2Q&) = delete;  // sum_ looks at the members

  void declare(Fields& f) override {
    control_.declare(f);
    f.under("positive.", "Q⁺", [&](Fields& g) { positive_.settings().declare(g); });
    f.under("negative.", "Q⁻", [&](Fields& g) { negative_.settings().declare(g); });
    f.under("split.", "", [&](Fields& g) { split_.declare(g); });
  }

  Action start(std::span<const double> state, Random& random) override {
    startUnguarded();
    a_ = choose(state, random);
    return go(a_);
  }
  Action step(const Outcome& outcome, std::span<const double> state, Random& random) override {
    const Action next = choose(state, random);
    learn(outcome, control_.discount, next);
    return go(next);
  }
  void end(const Outcome& outcome) override {
    learn(outcome, 0.0, 0);
    clearTraces();
  }
  Action truncate(const Outcome& outcome, std::span<const double> state, Random& random) override {
    const Action next = choose(state, random);
    learn(outcome, control_.discount, next);
    clearTraces();
    return next;
  }

  void abandon() override { clearTraces(); }

  const ActionValueFunction& values() const override { return sum_; }
  /// The traces of Q⁺, then those of Q⁻.
  void eligibility(std::vector<Eligibility>& z) const override {
    z.clear();
    positive_.eligibility(z, 0);
    negative_.eligibility(z, positive_.values().weightCount());
  }
  std::vector<NamedStep> lastSteps() const override {
    return {positive_.lastStep("positive"), negative_.lastStep("negative")};
  }
  bool diverged() const override { return positive_.diverged() || negative_.diverged(); }
  std::int64_t statesOutside() const override { return std::max(positive_.statesOutside(), negative_.statesOutside()); }

  void advance(const LifeTime& time) override {
    positive_.settings().stepSize.advance(time);
    negative_.settings().stepSize.advance(time);
  }
  bool everyStep() const override {
    return positive_.settings().stepSize.everyStep() || negative_.settings().stepSize.everyStep();
  }
  Json layouts() const override {
    return {{"positive", positive_.values().features().layout()}, {"negative", negative_.values().features().layout()}};
  }
  void fit(std::span<const double> state, Layer layer, std::span<const double> q, double share,
           double visits) override {
    if (layer == Layer::Positive) positive_.values().fit(state, q, share, visits);
    if (layer == Layer::Negative) negative_.values().fit(state, q, share, visits);
  }
  void transferValues(Archive& archive) override {
    archive.under("positive.", [&] { positive_.values().transfer(archive); });
    archive.under("negative.", [&] { negative_.values().transfer(archive); });
  }
  void transferLearning(Archive& archive) override {
    archive.value("action", a_, 0, static_cast<int>(q_.size()) - 1);
    transferChosen(archive);
    archive.under("positive.", [&] { positive_.transferLearning(archive); });
    archive.under("negative.", [&] { negative_.transferLearning(archive); });
  }

 private:
  /// A′ ~ π(·|S′) on Q⁺ + Q⁻.
  Action choose(std::span<const double> state, Random& random) {
    positive_.arrive(state, qPositive_);
    negative_.arrive(state, qNegative_);
    for (std::size_t a = 0; a < q_.size(); ++a) q_[a] = qPositive_[a] + qNegative_[a];
    return draw({state, q_, qNegative_}, pi_, random);
  }
  /// `discount` is γ, or 0 after a terminal step.
  void learn(const Outcome& outcome, double discount, Action next) {
    const auto [gain, loss] = split_(outcome);
    const auto b = static_cast<std::size_t>(next);
    positive_.learn(a_, gain, discount * qPositive_[b], control_.discount, control_.traces);
    negative_.learn(a_, loss, discount * qNegative_[b], control_.discount, control_.traces);
  }
  void clearTraces() {
    positive_.clearTrace();
    negative_.clearTrace();
  }
  Action go(Action next) {
    positive_.go();
    negative_.go();
    return a_ = next;
  }

  Estimate<P> positive_;
  Estimate<N> negative_;
  SplitActionValue<P, N> sum_;
  ControlSettings control_;
  RewardSplit split_;
  std::vector<double> q_, pi_, qPositive_, qNegative_;  // one entry an action
  Action a_ = 0;
};

}  // namespace surefoot
