// SPDX-License-Identifier: GPL-3.0-or-later
// x(s): from a state to the features that are on in it.
#pragma once

#include <concepts>
#include <cstdint>
#include <span>

namespace surefoot {

/// The number of a feature, or of a weight.
using Index = std::uint32_t;

/// The most features that may be on at once. Buffers of this size live on the stack.
inline constexpr int kMostActive = 128;

/// A value class with binary features, a fixed number of which is on in every state. No virtual call per feature.
///  - size(): how many features there are;
///  - active(): how many of them are on in a state (the tilings of a tile coder);
///  - activeFeatures(s, out): writes their numbers, all different, to `out` of length active(); says whether s lay
///    inside the declared range. Hot.
template <class F>
concept FeatureMap = std::copyable<F> && requires(const F& f, std::span<const double> state, std::span<Index> out) {
  { f.size() } -> std::convertible_to<Index>;
  { f.active() } -> std::convertible_to<int>;
  { f.activeFeatures(state, out) } -> std::same_as<bool>;
};

}  // namespace surefoot
