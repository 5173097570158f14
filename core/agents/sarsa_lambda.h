// SPDX-License-Identifier: GPL-3.0-or-later
// Sarsa(λ) with linear function approximation (thesis, eq. 2.4, 2.5, 2.8, 2.10; Sutton & Barto 2018, section 12.7).
#pragma once

#include <cmath>
#include <utility>

#include "core/agent.h"
#include "core/values/eligibility_trace.h"
#include "core/values/linear_action_value.h"

namespace surefoot {

enum class TraceKind : int { Replacing, Accumulating };
enum class OtherActions : int { Keep, Clear };

struct SarsaSettings {
  double stepSize = 0.4;
  double discount = 0.98;
  double traceDecay = 0.92;
  double traceCutoff = 0.01;
  TraceKind trace = TraceKind::Replacing;
  OtherActions otherActions = OtherActions::Keep;
  void declare(Fields& f);
};

template <FeatureMap F>
class SarsaLambda final : public Agent {
 public:
  SarsaLambda(LinearActionValue<F> values, const SarsaSettings& settings)
      : settings_(settings),
        values_(std::move(values)),
        trace_(values_.weights().size()) {
    x_.resize(static_cast<std::size_t>(values_.activeCount()));
    xNext_.resize(x_.size());
    q_.resize(static_cast<std::size_t>(values_.actions()));
    pi_.resize(q_.size());
  }

  void declare(Fields& f) override { settings_.declare(f); }

  Action start(std::span<const double> state, Random& random) override {
    trace_.clear();
    look(state, x_);
    return a_ = choose(x_, random);
  }

  Action step(const Outcome& outcome, std::span<const double> state, Random& random) override {
    look(state, xNext_);
    const Action next = choose(xNext_, random);
    learn(outcome.reward, settings_.discount * q_[static_cast<std::size_t>(next)]);
    std::swap(x_, xNext_);
    return a_ = next;
  }

  void end(const Outcome& outcome) override { learn(outcome.reward, 0.0); }

  void truncate(const Outcome& outcome, std::span<const double> state, Random& random) override {
    look(state, xNext_);
    const Action next = choose(xNext_, random);
    learn(outcome.reward, settings_.discount * q_[static_cast<std::size_t>(next)]);
  }

  const ActionValueFunction& values() const override { return values_; }
  void eligibility(std::vector<float>& z) const override {
    z.assign(values_.weights().size(), 0.0f);
    for (const auto& entry : trace_.entries()) z[entry.weight] = static_cast<float>(entry.z);
  }
  bool diverged() const override { return diverged_; }
  std::int64_t statesOutside() const override { return statesOutside_; }

 private:
  /// The update for (S, A) = (x_, a_), every value in it taken before. `next` is γ·q̂(S′, A′), or 0 at the end.
  void learn(double reward, double next) {
    // clang-format off
    const double gammaLambda = settings_.discount * settings_.traceDecay;
    const double alpha = settings_.stepSize / values_.activeCount();  // α/n: a step size of 1 closes the whole error
    const double delta = reward + next - values_.value(x_, a_);       // δ ← R + γ q̂(S′,A′) − q̂(S,A)
    trace_.decay(gammaLambda, settings_.traceCutoff);                 // z ← γλ z
    for (const Index i : x_) mark(i);                                 // z_i ← 1 for the active features of (S,A)
    trace_.addTo(values_.data(), alpha * delta);                      // w ← w + α δ z
    // clang-format on
    values_.countVisit(x_);
    diverged_ |= !(std::abs(delta) < kDivergedError);
  }

  void mark(Index feature) {
    if (settings_.otherActions == OtherActions::Clear)
      for (Action b = 0; b < values_.actions(); ++b)
        if (b != a_) trace_.drop(values_.weight(feature, b));
    const Index weight = values_.weight(feature, a_);
    settings_.trace == TraceKind::Replacing ? trace_.replace(weight) : trace_.accumulate(weight);
  }

  void look(std::span<const double> state, std::vector<Index>& x) {
    statesOutside_ += !values_.activeFeatures(state, x);
  }

  /// A ~ π(·|S) for the state with features x; leaves q̂(S, ·) in q_.
  Action choose(std::span<const Index> x, Random& random) {
    values_.values(x, q_);
    policy_->probabilities(q_, pi_);
    return sample(pi_, random);
  }

  SarsaSettings settings_;
  LinearActionValue<F> values_;
  EligibilityTrace trace_;
  std::vector<Index> x_, xNext_;  // active features of S and S′
  std::vector<double> q_, pi_;    // one entry an action
  Action a_ = 0;
  bool diverged_ = false;
  std::int64_t statesOutside_ = 0;
};

}  // namespace surefoot
