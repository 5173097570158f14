// SPDX-License-Identifier: GPL-3.0-or-later
// An estimate q̂ with everything that it learns with: features, weights, eligibility trace, step size. The agent
// chooses the target of learning. Thesis, eq. 2.4, 2.8 to 2.10; Sutton & Barto 2018, section 12.7.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/learned_step.h"
#include "core/schedule.h"
#include "core/values/deferred_trace.h"
#include "core/values/eligibility_trace.h"
#include "core/values/linear_action_value.h"

namespace surefoot {

enum class TraceKind : int { Replacing, Accumulating };
enum class OtherActions : int { Keep, Clear };

/// How one estimate learns.
struct EstimateSettings {
  Scheduled stepSize{0.4};   ///< α, over all active features together
  double traceDecay = 0.92;  ///< λ
  double asymmetry = 0.0;    ///< κ: errors below 0 count (1 + κ) times, those above (1 − κ) times
  void declare(Fields& f);
};

/// How traces are kept, shared by all estimates of an agent.
struct TraceSettings {
  double cutoff = 0.01;
  TraceKind kind = TraceKind::Replacing;
  OtherActions otherActions = OtherActions::Keep;
  void declare(Fields& f);
  void declareCutoff(Fields& f);
};

template <FeatureMap F>
class Estimate {
 public:
  Estimate(LinearActionValue<F> values, const EstimateSettings& settings)
      : settings_(settings),
        values_(std::move(values)) {}

  EstimateSettings& settings() { return settings_; }
  const EstimateSettings& settings() const { return settings_; }
  LinearActionValue<F>& values() { return values_; }
  const LinearActionValue<F>& values() const { return values_; }
  std::int64_t statesOutside() const { return statesOutside_; }
  /// The last temporal-difference error was beyond any sensible size.
  bool diverged() const { return diverged_; }
  const LearnedStep& last() const { return last_; }
  /// The last step, with `name` as the estimate's name.
  NamedStep lastStep(const char* name) const { return {name, last_, settings_.stepSize.now(), settings_.traceDecay}; }
  /// z_k of the weights that have a trace, written behind what is in `z` already; weights count from `first` on.
  void eligibility(std::vector<Eligibility>& z, std::uint64_t first) const;

  // One step of learning: arrive at S′, choose A′, learn about (S, A), go on from S′. Hot.

  void clearTrace() {
    deferred_.clear(values_.weights());
    plain_.clear(values_.weights());
  }
  /// S′ is this state: counts it, claims its features where a table is hashed; q ← q̂(S′, ·).
  void arrive(std::span<const double> state, std::span<double> q) {
    statesOutside_ += values_.claim(state, xNext()) == Cover::Edge;
    values_.values(xNext(), q);
  }
  /// q̂(S, a).
  double value(Action a) const { return values_.value(x_[here_], a); }
  /// S ← S′.
  void go() { here_ = 1 - here_; }

  /// Learns that (S, A) is worth R + next, where `next` is γ times the next state's value, computed before this update.
  void learn(Action a, double reward, double next, double discount, const TraceSettings& traces) {
    last_ = {reward, next, value(a)};
    const double delta = weighed(last_.delta());  // δ ← R + γ q̂(S′,·) − q̂(S,A)
    const double lambda = settings_.traceDecay;
    if (F::kBinary && traces.kind == TraceKind::Replacing)
      update(deferred_, a, alpha() * delta, discount * lambda, traces);
    else
      update(plain_, a, alpha() * delta, discount * lambda, traces);
    values_.countVisit(x());
    diverged_ |= !(std::abs(delta) < kDivergedError);
  }

  /// The same by true online TD(λ), with `old` = q̂(S, A) as it was when S was the next state (0 after a start):
  ///
  ///   z ← γλ z,   z ← z + (1 − α zᵀx) x,   w ← w + α (δ + q̂(S,A) − old) z − α (q̂(S,A) − old) x
  void learnTrueOnline(Action a, double reward, double next, double old, double discount, double cutoff) {
    last_ = {reward, next, value(a)};
    const double step = alpha(), changed = last_.before - old;
    plain_.decay(values_.weights(), discount * settings_.traceDecay, cutoff);
    double zx = 0.0;
    eachActive(a, [&](Index weight, double x) { zx += x * plain_.at(values_.weights(), weight); });
    eachActive(a, [&](Index weight, double x) { plain_.accumulate(values_.weights(), weight, (1.0 - step * zx) * x); });
    plain_.add(values_.weights(), step * (weighed(last_.delta()) + changed));
    eachActive(a, [&](Index weight, double x) { values_.weights().add(weight, -step * changed * x); });
    values_.countVisit(x());
    diverged_ |= !(std::abs(last_.delta()) < kDivergedError);
  }

  /// Everything but the tables: what a life needs to go on in the middle of an episode.
  void transferLearning(Archive& archive);

 private:
  /// Rewards are at most 1e6 a step; an error beyond this counts as divergence.
  static constexpr double kDivergedError = 1e12;

  using Active = typename F::Active;
  Active& x() { return x_[here_]; }          // active features of S
  Active& xNext() { return x_[1 - here_]; }  // active features of S′

  /// α/Σx²: a step size of 1 closes the whole error (α/n for n binary features).
  double alpha() {
    const double length = values_.squaredLength(x());
    return settings_.stepSize.now() / (length > 0 ? length : 1.0);
  }
  /// Risk-sensitive learning (Mihatsch & Neuneier 2002, Machine Learning 49): with κ above 0 bad news count more.
  double weighed(double delta) const {
    const double kappa = settings_.asymmetry;
    return kappa == 0.0 ? delta : (delta < 0.0 ? 1.0 + kappa : 1.0 - kappa) * delta;
  }
  /// f(weight, x) for the active features of (S, a).
  void eachActive(Action a, const auto& f) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(x().count); ++k) f(values_.weight(x(), k, a), x().valueOf(k));
  }
  template <class Trace>
  void update(Trace& trace, Action a, double alphaDelta, double gammaLambda, const TraceSettings& traces) {
    if (traces.kind != kind_) clearTrace(), kind_ = traces.kind;  // the kind was changed while the life went on
    trace.decay(values_.weights(), gammaLambda, traces.cutoff);   // z ← γλ z
    mark(trace, a, traces);                                       // z_i ← 1 for the active features of (S,A)
    trace.add(values_.weights(), alphaDelta);                     // w ← w + α δ z
  }
  template <class Trace>
  void mark(Trace& trace, Action a, const TraceSettings& traces) {
    if (traces.otherActions == OtherActions::Clear)
      for (std::size_t k = 0; k < static_cast<std::size_t>(x().count); ++k)
        for (Index c = 0; c < values_.columns(); ++c)
          if (const Index other = x().index[k] * values_.columns() + c; other != values_.weight(x(), k, a))
            trace.drop(values_.weights(), other);
    if constexpr (std::is_same_v<Trace, DeferredTrace>) {
      if (!values_.sharesWeights())
        return trace.replace(values_.weights(), x().indices(), values_.columns(), static_cast<Index>(a));
      std::array<Index, std::tuple_size_v<decltype(Active::index)>> marked;
      for (std::size_t k = 0; k < static_cast<std::size_t>(x().count); ++k) marked[k] = values_.weight(x(), k, a);
      trace.replace(values_.weights(), {marked.data(), static_cast<std::size_t>(x().count)}, 1, 0);
    } else
      for (std::size_t k = 0; k < static_cast<std::size_t>(x().count); ++k) {
        const Index weight = values_.weight(x(), k, a);
        if (traces.kind == TraceKind::Accumulating)
          trace.accumulate(values_.weights(), weight, x().valueOf(k));
        else
          trace.raise(values_.weights(), weight, x().valueOf(k));
      }
  }

  EstimateSettings settings_;
  LinearActionValue<F> values_;
  DeferredTrace deferred_;  // replacing traces of binary features
  EligibilityTrace plain_;  // all others
  TraceKind kind_ = TraceKind::Replacing;
  std::array<Active, 2> x_;  // active features of S and S′, taking turns
  std::size_t here_ = 0;
  bool diverged_ = false;
  LearnedStep last_;
  std::int64_t statesOutside_ = 0;
};

template <FeatureMap F>
void Estimate<F>::eligibility(std::vector<Eligibility>& z, std::uint64_t first) const {
  const auto before = static_cast<std::ptrdiff_t>(z.size());
  deferred_.forEach(values_.weights(), [&](Index k, double value) {
    z.push_back({first + k, static_cast<float>(value)});
  });
  for (const auto& entry : plain_.entries()) z.push_back({first + entry.weight, static_cast<float>(entry.z)});
  std::sort(z.begin() + before, z.end(), [](const auto& a, const auto& b) { return a.weight < b.weight; });
}

template <FeatureMap F>
void Estimate<F>::transferLearning(Archive& archive) {
  archive.value("diverged", diverged_, 0, 1);
  archive.value("states_outside", statesOutside_, 0, std::numeric_limits<std::int64_t>::max());
  archive.value("trace_kind", kind_, 0, 1);
  if constexpr (ClaimingFeatureMap<F>) {
    std::int64_t failed = values_.features().failedLookUps();
    archive.value("failed_look_ups", failed, 0, std::numeric_limits<std::int64_t>::max());
    values_.features().setFailedLookUps(failed);
  }
  archive.under("deferred.", [&] { deferred_.transfer(values_.weights(), archive); });
  archive.under("trace.", [&] { plain_.transfer(values_.weights(), archive); });

  std::vector<Index> features(x().indices().begin(), x().indices().end());
  std::vector<double> values;
  for (std::size_t k = 0; k < features.size(); ++k) values.push_back(x().valueOf(k));
  archive.list("features", features, x().index.size());
  archive.list("feature_values", values, x().index.size());
  if (!archive.reading() || !archive.good()) return;
  std::size_t size = values_.features().size();
  if constexpr (ClaimingFeatureMap<F>) size = values_.features().occupied();  // the rows that are there
  if (features.size() != values.size() ||
      std::any_of(features.begin(), features.end(), [=](Index i) { return i >= size; }))
    return archive.refuse("features", "does not fit the table");
  x().count = static_cast<int>(features.size());
  std::copy(features.begin(), features.end(), x().index.begin());
  if constexpr (!F::kBinary) std::copy(values.begin(), values.end(), x().value.begin());
}

}  // namespace surefoot
