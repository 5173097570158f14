// SPDX-License-Identifier: GPL-3.0-or-later
// x(s): from a state to its active features, with their values.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "core/basics/result.h"

namespace surefoot {

/// The number of a feature, or of a weight.
using Index = std::uint32_t;

/// Where a state lies: inside the range of a feature map; beyond it, which counts as at the edge; or outside the box
/// that the map is confined to, where no feature is on.
enum class Cover : std::uint8_t { Inside, Edge, Nothing };

/// The features that are on in one state. Binary features are worth 1 each and have no list of values. Lives on the
/// stack or in a learner; nothing is initialised beyond `count`.
template <int kMost, bool kBinary>
struct ActiveFeatures {
  int count = 0;
  std::array<Index, kMost> index;
  std::array<double, kBinary ? 0 : kMost> value;

  std::span<const Index> indices() const { return {index.data(), static_cast<std::size_t>(count)}; }
  double valueOf(std::size_t k) const {
    if constexpr (kBinary)
      return 1.0;
    else
      return value[k];
  }
};

/// A value class. No virtual call per feature.
///  - kBinary: every feature that is on is worth 1, and the same number of them is on in every state;
///  - size(): how many features there are;
///  - total(): Σ x, the same in every state (the tilings of a tile coder; 1 for normalised features);
///  - find(s, x): the features of s. Changes nothing. Hot;
///  - layout(): everything that the numbers of the features depend on, for files;
///  - shape(): the features as a table, slowest index first: its product is size().
/// A map may also have claim(s, x), for the learner: the same, but the map may take note of the state.
template <class F>
concept FeatureMap = std::copyable<F> && requires(const F& f, std::span<const double> state, typename F::Active& x) {
  { F::kBinary } -> std::convertible_to<bool>;
  { f.size() } -> std::convertible_to<Index>;
  { f.total() } -> std::convertible_to<double>;
  { f.find(state, x) } -> std::same_as<Cover>;
  { f.layout() } -> std::same_as<nlohmann::json>;
  { f.shape() } -> std::same_as<std::vector<std::size_t>>;
};

/// A feature map that says which weight of a feature an action has, where near actions share weights (ActionTiles).
template <class F>
concept ActionSharing = FeatureMap<F> && requires(const F& f) {
  f.actionTiles();
};

/// Number of weights of a feature.
template <FeatureMap F>
std::size_t columnsOf(const F& features, int actions) {
  if constexpr (ActionSharing<F>)
    if (features.actionTiles().shared()) return features.actionTiles().count();
  return static_cast<std::size_t>(actions);
}

/// A feature map whose features are claimed while it is used: a hashed table.
template <class F>
concept ClaimingFeatureMap = FeatureMap<F> && requires(F& f, std::span<const double> state, typename F::Active& x) {
  { f.claim(state, x) } -> std::same_as<Cover>;
};

}  // namespace surefoot
