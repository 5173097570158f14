// SPDX-License-Identifier: GPL-3.0-or-later
// Linear function approximation (thesis, eq. 2.9; Sutton & Barto 2018, section 10.1):
//
//   q̂(s, a, w) = Σ_i w(i, a) x_i(s) over the active features i of s, where x_i is 1 for binary features
//
// Weights lie as [feature][column], so that one feature number serves all actions. A column is an action, or, where
// near actions share weights, one of their tiles (ActionTiles): then w(i, a) is the weight of the action's tile.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <vector>

#include "core/action_value.h"
#include "core/basics/expects.h"
#include "core/basics/random.h"
#include "core/features/feature_map.h"
#include "core/files/archive.h"
#include "core/values/initial_value.h"
#include "core/values/shared_weights.h"
#include "core/values/weight_table.h"

namespace surefoot {

template <FeatureMap F>
class LinearActionValue final : public ActionValueFunction {
 public:
  using Active = typename F::Active;

  LinearActionValue(F features, int actions, const InitialValue& initial, std::uint64_t seed)
      : features_(std::move(features)),
        actions_(static_cast<std::size_t>(actions)),
        columns_(columnsOf(features_, actions)),
        initial_(initial),
        seed_(seed),
        weights_(0, features_.size() * columns_) {
    visits_.reserve(features_.size());
    grow();
  }

  // Called by the learner, once a state and not once a feature. Hot.

  /// The active features of a state that a learner comes to.
  Cover claim(std::span<const double> state, Active& x) {
    if constexpr (ClaimingFeatureMap<F>) {
      const Cover cover = features_.claim(state, x);
      if (rows() != visits_.size()) grow();
      return cover;
    } else {
      return features_.find(state, x);
    }
  }
  /// q ← q̂(s, ·) for the state with the active features x.
  void values(const Active& x, std::span<double> q) const {
    if constexpr (ActionSharing<F>)
      if (sharesWeights()) return sumShared(weights_, x.indices(), columns_, features_.actionTiles(), q);
    if constexpr (F::kBinary) return weights_.sumRows(x.indices(), actions_, q.data());
    for (double& value : q) value = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(x.count); ++k)
      for (std::size_t a = 0; a < actions_; ++a) q[a] += weights_[x.index[k] * actions_ + a] * x.valueOf(k);
  }
  /// Whether near actions share weights.
  bool sharesWeights() const {
    if constexpr (ActionSharing<F>)
      return features_.actionTiles().shared();
    else
      return false;
  }
  /// q̂(s, a).
  double value(const Active& x, Action a) const {
    if (F::kBinary && !sharesWeights())
      return weights_.sum(x.indices(), static_cast<Index>(actions_), static_cast<Index>(a));
    double sum = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(x.count); ++k) sum += weights_[weight(x, k, a)] * x.valueOf(k);
    return sum;
  }
  /// Σ x²: the share of an error δ that w ← w + δ x closes. (Outside a box no feature is on; what is learned there
  /// reaches earlier states through their traces.)
  double squaredLength(const Active& x) const {
    if constexpr (F::kBinary) return features_.total();
    double sum = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(x.count); ++k) sum += x.valueOf(k) * x.valueOf(k);
    return sum;
  }
  /// The number of the weight of the k-th feature of x and action a.
  Index weight(const Active& x, std::size_t k, Action a) const {
    return static_cast<Index>(x.index[k] * columns_ + columnOf(k, a));
  }
  /// Where the k-th feature of a state keeps the weight of an action.
  std::size_t columnOf(std::size_t k, Action a) const {
    if constexpr (ActionSharing<F>)
      if (sharesWeights()) return features_.actionTiles().column(k, a);
    return static_cast<std::size_t>(a);
  }
  /// Weights of a feature.
  Index columns() const { return static_cast<Index>(columns_); }
  WeightTable& weights() { return weights_; }
  const WeightTable& weights() const { return weights_; }
  /// Weights of the features claimed so far, and of a few more.
  std::size_t weightCount() const { return weights_.size(); }
  /// Counts a visit of the features of x; if they are not binary, only of those at least half as strong as the
  /// strongest.
  void countVisit(const Active& x) {
    double least = 0.0;
    std::uint32_t* const visits = visits_.data();
    const std::span<const Index> indices = x.indices();
    if constexpr (!F::kBinary)
      for (std::size_t k = 0; k < indices.size(); ++k) least = std::max(least, x.valueOf(k) / 2);
    for (std::size_t k = 0; k < indices.size(); ++k)
      if (F::kBinary || x.valueOf(k) >= least) visits[indices[k]] += visits[indices[k]] != kMostVisits;
  }

  /// Moves q̂(s, ·) towards `q`, closing the given share of the error; its features count as visited at least so often.
  void fit(std::span<const double> state, std::span<const double> q, double share, double visits) {
    Active x;
    claim(state, x);
    const double length = response(x);
    for (std::size_t a = 0; a < actions_; ++a) {
      const double error = q[a] - value(x, static_cast<Action>(a));
      for (std::size_t k = 0; k < static_cast<std::size_t>(x.count); ++k)
        weights_.add(weight(x, k, static_cast<Action>(a)), share * error * x.valueOf(k) / length);
    }
    const auto count = static_cast<std::uint32_t>(std::min(std::ceil(visits), static_cast<double>(kMostVisits)));
    for (const Index i : x.indices()) visits_[i] = std::max(visits_[i], count);
  }
  /// Whole tables, to a file or from one.
  void transfer(Archive& archive) {
    std::vector<std::size_t> shape = features_.shape();
    if constexpr (ClaimingFeatureMap<F>) {
      std::vector<std::uint64_t> tiles(features_.tiles().begin(), features_.tiles().end());
      archive.list("tiles", tiles, features_.size());
      archive.value("initial_low", initial_.low);  // for features that are claimed later
      archive.value("initial_high", initial_.high);
      archive.value("initial_seed", seed_);
      if (archive.reading() && archive.good()) {
        if (const Status s = features_.setTiles(tiles); !s) return archive.refuse("tiles", s.error().message);
        weights_.resize(0);
        visits_.clear();
        grow();
      }
      shape = {features_.occupied()};
    }
    const std::size_t count = std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
    std::vector<std::uint32_t> visits(visits_.begin(), visits_.begin() + static_cast<std::ptrdiff_t>(count));
    archive.table("visits", visits, shape);
    shape.push_back(columns_);
    std::vector<double> weights = weights_.settled(count * columns_);
    archive.table("weights", weights, shape);
    if (!archive.reading() || !archive.good()) return;
    weights_.settle();
    std::copy(visits.begin(), visits.end(), visits_.begin());
    for (std::size_t k = 0; k < weights.size(); ++k) weights_.set(k, weights[k]);
  }
  const F& features() const { return features_; }
  F& features() { return features_; }

  // ActionValueFunction

  int actions() const override { return static_cast<int>(actions_); }
  void evaluate(std::span<const double> state, Layer, std::span<double> q) const override {
    Active x;
    features_.find(state, x);
    values(x, q);
  }
  double visits(std::span<const double> state) const override {
    return mean(state, [&](Index i) { return static_cast<double>(visits_[i]); });
  }
  double familiarity(std::span<const double> state) const override {
    return mean(state, [&](Index i) { return visits_[i] > 0 ? 1.0 : 0.0; });
  }
  void average(std::span<const Eligibility> z, std::span<const double> state, std::span<double> out) const override {
    Active x;
    features_.find(state, x);
    std::fill(out.begin(), out.end(), 0.0);
    for (std::size_t k = 0; k < static_cast<std::size_t>(x.count); ++k) {
      const std::uint64_t first = std::uint64_t{x.index[k]} * columns_;
      auto entry = std::lower_bound(z.begin(), z.end(), first,
                                    [](const Eligibility& e, std::uint64_t weight) { return e.weight < weight; });
      for (; entry != z.end() && entry->weight < first + columns_; ++entry)
        for (std::size_t a = 0; a < actions_; ++a)
          if (first + columnOf(k, static_cast<Action>(a)) == entry->weight)
            out[a] += x.valueOf(k) * static_cast<double>(entry->z) / features_.total();
    }
  }
  std::size_t bytes() const override { return weights_.size() * 2 * sizeof(double) + features_.size() * 16; }
  std::vector<std::vector<double>> tables() const override { return {weights_.settled()}; }
  std::vector<MemoryUse> memoryUse() const override {
    MemoryUse use{.slots = features_.size(), .occupied = {}, .failedLookUps = {}};
    if constexpr (ClaimingFeatureMap<F>) {
      use.occupied = features_.occupied();
      use.failedLookUps = features_.failedLookUps();
    }
    return {use};
  }
  std::unique_ptr<ActionValueFunction> clone() const override { return copy(); }
  std::unique_ptr<LinearActionValue> copy() const {
    auto copy = std::make_unique<LinearActionValue>(*this);
    copy->unsettled_.assign(visits_.size(), false);
    for (std::size_t i = 0; i < visits_.size(); ++i)
      for (std::size_t k = i * columns_; k < (i + 1) * columns_ && !copy->unsettled_[i]; ++k)
        copy->unsettled_[i] = weights_.putOff(k);
    copy->weights_.settle();
    return copy;
  }
  /// This must be a clone of `other`. Rows that were not visited since the last copy are left as they are.
  void assign(const ActionValueFunction& other) override {
    const auto& same = dynamic_cast<const LinearActionValue&>(other);
    expects(same.columns_ == columns_ && same.visits_.size() >= visits_.size() && !unsettled_.empty(),
            "only a clone takes over its original");
    if constexpr (ClaimingFeatureMap<F>)
      if (features_.occupied() != same.features_.occupied()) features_ = same.features_;
    grow();
    unsettled_.resize(visits_.size(), false);
    const bool all = !F::kBinary || same.weights_.added();
    for (std::size_t i = 0; i < visits_.size(); ++i) {
      if (!all && !unsettled_[i] && visits_[i] == same.visits_[i] && visits_[i] != kMostVisits) continue;
      unsettled_[i] = weights_.copy(same.weights_, i * columns_, columns_);
      visits_[i] = same.visits_[i];
    }
  }

 private:
  /// Number of features with weights: all; in a hashed table the claimed ones and as many more as one look-up can meet.
  std::size_t rows() const {
    if constexpr (ClaimingFeatureMap<F>)
      return std::min<std::size_t>(features_.size(), features_.occupied() + std::tuple_size_v<decltype(Active::index)>);
    else
      return features_.size();
  }
  /// Gives new rows their initial weights; the memory is reserved already.
  void grow() {
    const double low = initial_.low / features_.total();
    const double high = initial_.high / features_.total();
    const std::size_t before = weights_.size();
    weights_.resize(rows() * columns_);
    const auto initial = [&](std::size_t k) { return low == high ? low : low + (high - low) * uniformAt(seed_, k); };
    if (low != 0.0 || high != 0.0)  // they are 0 already
      for (std::size_t k = before; k < weights_.size(); ++k) weights_.set(k, initial(k));
    visits_.resize(rows(), 0);
  }
  /// How much q̂(s) moves if every weight of x moves by its x: Σ x², and more where hashed features share a weight.
  double response(const Active& x) const {
    if constexpr (!ClaimingFeatureMap<F>) return squaredLength(x);
    double pairs = 0.0;
    for (const Index i : x.indices())
      pairs += static_cast<double>(std::count(x.indices().begin(), x.indices().end(), i));
    return pairs;
  }
  /// Σ x·quantity / Σ x over the features of a state.
  double mean(std::span<const double> state, const auto& quantity) const {
    Active x;
    features_.find(state, x);
    double sum = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(x.count); ++k) sum += x.valueOf(k) * quantity(x.index[k]);
    return sum / features_.total();
  }

  static constexpr std::uint32_t kMostVisits = ~std::uint32_t{0};

  F features_;
  std::size_t actions_, columns_;
  InitialValue initial_;
  std::uint64_t seed_;
  WeightTable weights_;                // [feature][column]
  std::vector<std::uint32_t> visits_;  // [feature]
  std::vector<bool> unsettled_;        // [feature] in a clone: may have changed without another visit
};

}  // namespace surefoot
