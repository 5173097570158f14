// SPDX-License-Identifier: GPL-3.0-or-later
// An estimate q̂ with all that learns it: features, weights, eligibility trace, step size. What is learned (the target)
// is the agent's business. Thesis, eq. 2.4, 2.8 to 2.10; Sutton & Barto 2018, section 12.7.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include "core/values/eligibility_trace.h"
#include "core/values/linear_action_value.h"

namespace surefoot {

enum class TraceKind : int { Replacing, Accumulating };
enum class OtherActions : int { Keep, Clear };

/// How one estimate learns.
struct EstimateSettings {
  double stepSize = 0.4;     ///< α, over all active features together
  double traceDecay = 0.92;  ///< λ
  void declare(Fields& f);
};

/// How traces are kept, shared by all estimates of an agent.
struct TraceSettings {
  double cutoff = 0.01;
  TraceKind kind = TraceKind::Replacing;
  OtherActions otherActions = OtherActions::Keep;
  void declare(Fields& f);
};

template <FeatureMap F>
class Estimate {
 public:
  Estimate(LinearActionValue<F> values, const EstimateSettings& settings)
      : settings_(settings),
        values_(std::move(values)),
        trace_(values_.weightCount()) {
    x_.resize(static_cast<std::size_t>(values_.activeCount()));
    xNext_.resize(x_.size());
  }

  EstimateSettings& settings() { return settings_; }
  const LinearActionValue<F>& values() const { return values_; }
  const EligibilityTrace& trace() const { return trace_; }
  std::int64_t statesOutside() const { return statesOutside_; }
  /// The last temporal-difference error was beyond any sensible size.
  bool diverged() const { return diverged_; }

  // One step of learning: look at S′, choose A′ from what is seen, learn about (S, A), go to S′. Hot.

  void clearTrace() { trace_.clear(); }
  /// Looks at the next state; q ← q̂(S′, ·).
  void look(std::span<const double> state, std::span<double> q) {
    statesOutside_ += !values_.activeFeatures(state, xNext_);
    values_.values(xNext_, q);
  }
  /// S ← S′.
  void go() { std::swap(x_, xNext_); }

  /// Learns that (S, A) is worth R + next, where `next` is γ times the value of what follows, taken before this update.
  void learn(Action a, double reward, double next, double discount, const TraceSettings& traces) {
    // clang-format off
    const double alpha = settings_.stepSize / values_.activeCount();  // α/n: a step size of 1 closes the whole error
    const double delta = reward + next - values_.value(x_, a);        // δ ← R + γ q̂(S′,·) − q̂(S,A)
    trace_.decay(discount * settings_.traceDecay, traces.cutoff);     // z ← γλ z
    for (const Index i : x_) mark(i, a, traces);                      // z_i ← 1 for the active features of (S,A)
    trace_.addTo(values_.data(), alpha * delta);                      // w ← w + α δ z
    // clang-format on
    values_.countVisit(x_);
    diverged_ |= !(std::abs(delta) < kDivergedError);
  }

 private:
  /// Rewards are at most 1e6 a step; an error beyond this counts as divergence.
  static constexpr double kDivergedError = 1e12;

  void mark(Index feature, Action a, const TraceSettings& traces) {
    if (traces.otherActions == OtherActions::Clear)
      for (Action b = 0; b < values_.actions(); ++b)
        if (b != a) trace_.drop(values_.weight(feature, b));
    const Index weight = values_.weight(feature, a);
    traces.kind == TraceKind::Replacing ? trace_.replace(weight) : trace_.accumulate(weight);
  }

  EstimateSettings settings_;
  LinearActionValue<F> values_;
  EligibilityTrace trace_;
  std::vector<Index> x_, xNext_;  // active features of S and S′
  bool diverged_ = false;
  std::int64_t statesOutside_ = 0;
};

}  // namespace surefoot
