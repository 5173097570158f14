// SPDX-License-Identifier: GPL-3.0-or-later
// Linear function approximation with binary features (thesis, eq. 2.9; Sutton & Barto 2018, section 10.1):
//
//   q̂(s, a, w) = Σ_i w(i, a) over the active features i of s
//
// Weights lie as [feature][action], so that one feature number serves all actions.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "core/action_value.h"
#include "core/features/feature_map.h"
#include "core/parameters.h"
#include "core/random.h"

namespace surefoot {

/// Range of the initial value of a state-action pair: every weight starts uniform in [low/n, high/n], n active
/// features.
struct InitialValue {
  double low = 0.0;
  double high = 0.1;
  void declare(Fields& f) {
    f.real(low, {.key = "initial_low",
                 .title = "Initial Q, low",
                 .symbol = "",
                 .unit = "",
                 .low = -1e6,
                 .high = 1e6,
                 .sliderLow = -100,
                 .sliderHigh = 200,
                 .when = When::NewTable,
                 .group = Group::Representation,
                 .help = "Lowest value of a pair before anything is learned.",
                 .origin = "thesis, section 3.1.3",
                 .order = 3});
    f.real(high, {.key = "initial_high",
                  .title = "Initial Q",
                  .symbol = "",
                  .unit = "",
                  .low = -1e6,
                  .high = 1e6,
                  .sliderLow = 0,
                  .sliderHigh = 10,
                  .when = When::NewTable,
                  .group = Group::Representation,
                  .help = "Highest value of a pair before anything is learned.",
                  .origin = "thesis, section 3.1.3",
                  .order = 2});
  }
};

template <FeatureMap F>
class LinearActionValue final : public ActionValueFunction {
 public:
  LinearActionValue(F features, int actions, const InitialValue& initial, std::uint64_t seed)
      : features_(std::move(features)),
        actions_(static_cast<std::size_t>(actions)) {
    assert(features_.active() <= kMostActive);
    const double low = initial.low / features_.active();
    const double high = initial.high / features_.active();
    weights_.resize(features_.size() * actions_);
    for (std::size_t i = 0; i < weights_.size(); ++i) weights_[i] = low + (high - low) * uniformAt(seed, i);
    visits_.assign(features_.size(), 0);
  }

  // Called by the learner, once a state and not once a feature. Hot.

  int activeCount() const { return features_.active(); }
  bool activeFeatures(std::span<const double> state, std::span<Index> x) const {
    return features_.activeFeatures(state, x);
  }
  /// q ← q̂(s, ·) for the state with the active features x.
  void values(std::span<const Index> x, std::span<double> q) const {
    for (double& value : q) value = 0.0;
    for (const Index i : x) {
      const double* row = &weights_[i * actions_];
      for (std::size_t a = 0; a < actions_; ++a) q[a] += row[a];
    }
  }
  /// q̂(s, a).
  double value(std::span<const Index> x, Action a) const {
    double sum = 0.0;
    for (const Index i : x) sum += weights_[weight(i, a)];
    return sum;
  }
  /// The number of the weight of feature i and action a.
  Index weight(Index i, Action a) const { return i * static_cast<Index>(actions_) + static_cast<Index>(a); }
  double* data() { return weights_.data(); }
  std::size_t weightCount() const { return weights_.size(); }
  void countVisit(std::span<const Index> x) {
    for (const Index i : x) visits_[i] += visits_[i] != kMostVisits;
  }

  // ActionValueFunction

  int actions() const override { return static_cast<int>(actions_); }
  void evaluate(std::span<const double> state, Layer, std::span<double> q) const override {
    values(look(state).features(), q);
  }
  double visits(std::span<const double> state) const override {
    double sum = 0.0;
    for (const Index i : look(state)) sum += visits_[i];
    return sum / features_.active();
  }
  double familiarity(std::span<const double> state) const override {
    int seen = 0;
    for (const Index i : look(state)) seen += visits_[i] > 0;
    return static_cast<double>(seen) / features_.active();
  }
  void average(std::span<const float> perWeight, std::span<const double> state, std::span<double> out) const override {
    for (double& value : out) value = 0.0;
    for (const Index i : look(state))
      for (std::size_t a = 0; a < actions_; ++a) out[a] += static_cast<double>(perWeight[i * actions_ + a]);
    for (double& value : out) value /= features_.active();
  }
  std::vector<std::span<const double>> tables() const override { return {weights_}; }
  std::unique_ptr<ActionValueFunction> clone() const override { return std::make_unique<LinearActionValue>(*this); }
  void assign(const ActionValueFunction& other) override {
    const auto& same = dynamic_cast<const LinearActionValue&>(other);
    assert(same.weights_.size() == weights_.size());
    std::copy(same.weights_.begin(), same.weights_.end(), weights_.begin());
    std::copy(same.visits_.begin(), same.visits_.end(), visits_.begin());
  }

 private:
  /// The active features of a state, for those who only look.
  struct Looked {
    std::array<Index, kMostActive> x;
    std::size_t count;
    std::span<const Index> features() const { return {x.data(), count}; }
    const Index* begin() const { return x.data(); }
    const Index* end() const { return x.data() + count; }
  };
  Looked look(std::span<const double> state) const {
    Looked looked;
    looked.count = static_cast<std::size_t>(features_.active());
    features_.activeFeatures(state, std::span(looked.x.data(), looked.count));
    return looked;
  }

  static constexpr std::uint32_t kMostVisits = ~std::uint32_t{0};

  F features_;
  std::size_t actions_;
  std::vector<double> weights_;        // [feature][action]
  std::vector<std::uint32_t> visits_;  // [feature]
};

}  // namespace surefoot
