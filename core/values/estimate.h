// SPDX-License-Identifier: GPL-3.0-or-later
// An estimate q̂ with all that learns it: features, weights, eligibility trace, step size. What is learned (the target)
// is the agent's business. Thesis, eq. 2.4, 2.8 to 2.10; Sutton & Barto 2018, section 12.7.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/schedule.h"
#include "core/values/eligibility_trace.h"
#include "core/values/linear_action_value.h"

namespace surefoot {

enum class TraceKind : int { Replacing, Accumulating };
enum class OtherActions : int { Keep, Clear };

/// How one estimate learns.
struct EstimateSettings {
  Scheduled stepSize{0.4};   ///< α, over all active features together
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
        trace_(values_.weightCount()) {}

  EstimateSettings& settings() { return settings_; }
  const EstimateSettings& settings() const { return settings_; }
  LinearActionValue<F>& values() { return values_; }
  const LinearActionValue<F>& values() const { return values_; }
  const EligibilityTrace& trace() const { return trace_; }
  std::int64_t statesOutside() const { return statesOutside_; }
  /// The last temporal-difference error was beyond any sensible size.
  bool diverged() const { return diverged_; }

  // One step of learning: look at S′, choose A′ from what is seen, learn about (S, A), go to S′. Hot.

  void clearTrace() { trace_.clear(); }
  /// Looks at the next state; q ← q̂(S′, ·).
  void look(std::span<const double> state, std::span<double> q) {
    statesOutside_ += values_.claim(state, xNext()) == Cover::Edge;
    values_.values(xNext(), q);
  }
  /// q̂(S, a).
  double value(Action a) const { return values_.value(x_[here_], a); }
  /// S ← S′.
  void go() { here_ = 1 - here_; }

  /// Learns that (S, A) is worth R + next, where `next` is γ times the value of what follows, taken before this update.
  void learn(Action a, double reward, double next, double discount, const TraceSettings& traces) {
    // clang-format off
    const double delta = reward + next - values_.value(x(), a);       // δ ← R + γ q̂(S′,·) − q̂(S,A)
    trace_.decay(discount * settings_.traceDecay, traces.cutoff);     // z ← γλ z
    mark(a, traces);                                                  // z_i ← 1 for the active features of (S,A)
    trace_.addTo(values_.data(), alpha() * delta);                    // w ← w + α δ z
    // clang-format on
    values_.countVisit(x());
    diverged_ |= !(std::abs(delta) < kDivergedError);
  }

  /// Everything but the tables: what a life needs to go on in the middle of an episode.
  void transferLearning(Archive& archive);

 private:
  /// Rewards are at most 1e6 a step; an error beyond this counts as divergence.
  static constexpr double kDivergedError = 1e12;

  using Active = typename F::Active;
  Active& x() { return x_[here_]; }          // of S
  Active& xNext() { return x_[1 - here_]; }  // of S′

  /// α/Σx²: a step size of 1 closes the whole error (α/n for n binary features).
  double alpha() {
    const double length = values_.squaredLength(x());
    return settings_.stepSize.now() / (length > 0 ? length : 1.0);
  }
  void mark(Action a, const TraceSettings& traces) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(x().count); ++k) {
      const Index feature = x().index[k], weight = values_.weight(feature, a);
      if (traces.otherActions == OtherActions::Clear)
        for (Action b = 0; b < values_.actions(); ++b)
          if (b != a) trace_.drop(values_.weight(feature, b));
      if (traces.kind == TraceKind::Accumulating)
        trace_.accumulate(weight, x().valueOf(k));
      else if constexpr (F::kBinary)
        trace_.replace(weight);
      else
        trace_.raise(weight, x().valueOf(k));
    }
  }

  EstimateSettings settings_;
  LinearActionValue<F> values_;
  EligibilityTrace trace_;
  std::array<Active, 2> x_;  // active features of S and S′, taking turns
  std::size_t here_ = 0;
  bool diverged_ = false;
  std::int64_t statesOutside_ = 0;
};

template <FeatureMap F>
void Estimate<F>::transferLearning(Archive& archive) {
  archive.value("diverged", diverged_, 0, 1);
  archive.value("states_outside", statesOutside_);
  if constexpr (ClaimingFeatureMap<F>) {
    std::int64_t failed = values_.features().failedLookUps();
    archive.value("failed_look_ups", failed);
    values_.features().setFailedLookUps(failed);
  }
  std::vector<Index> weights, features(x().indices().begin(), x().indices().end());
  std::vector<double> z, values;
  for (const auto& entry : trace_.entries()) weights.push_back(entry.weight), z.push_back(entry.z);
  for (std::size_t k = 0; k < features.size(); ++k) values.push_back(x().valueOf(k));
  archive.list("trace.weights", weights, values_.weightCount());
  archive.list("trace.z", z, values_.weightCount());
  archive.list("features", features, x().index.size());
  archive.list("feature_values", values, x().index.size());
  if (!archive.reading() || !archive.good()) return;

  const auto below = [](const std::vector<Index>& list, std::size_t limit) {
    return std::all_of(list.begin(), list.end(), [=](Index i) { return i < limit; });
  };
  if (weights.size() != z.size() || !below(weights, values_.weightCount()))
    return archive.refuse("trace.weights", "does not fit the table");
  if (features.size() != values.size() || !below(features, values_.features().size()))
    return archive.refuse("features", "does not fit the table");
  std::vector<EligibilityTrace::Entry> entries;
  for (std::size_t i = 0; i < weights.size(); ++i) entries.push_back({weights[i], z[i]});
  trace_.setEntries(entries);
  x().count = static_cast<int>(features.size());
  std::copy(features.begin(), features.end(), x().index.begin());
  if constexpr (!F::kBinary) std::copy(values.begin(), values.end(), x().value.begin());
}

}  // namespace surefoot
