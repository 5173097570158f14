// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/values/shared_weights.h"

#include <algorithm>
#include <array>

namespace surefoot {

namespace {

/// The features of one evaluation.
struct Blocks {
  const WeightTable& weights;
  std::span<const Index> features;
  std::size_t columns;
  const ActionTiles& tiles;

  std::size_t first(std::size_t k) const { return features[k] * columns; }

  /// Adds the weights of several features, from the k-th on. A block is settled once and then serves all actions.
  template <std::size_t kCount>
  void add(std::size_t k, std::span<double> q) const {
    std::array<std::array<double, ActionTiles::kMostColumns>, kCount> block;
    std::array<const std::uint16_t*, kCount> column;
    for (std::size_t i = 0; i < kCount; ++i) {
      weights.settle(first(k + i), tiles.reach(k + i), block[i].data());
      column[i] = tiles.columnsOf(k + i).data();
    }
    for (std::size_t a = 0; a < q.size(); ++a) {
      double sum = q[a];
      for (std::size_t i = 0; i < kCount; ++i) sum += block[i][column[i][a]];
      q[a] = sum;
    }
  }
};

}  // namespace

void sumShared(const WeightTable& weights, std::span<const Index> features, std::size_t columns,
               const ActionTiles& tiles, std::span<double> q) {
  constexpr std::size_t kTogether = 4;  // a sum is loaded and stored once for all of them
  const Blocks blocks{weights, features, columns, tiles};
  for (std::size_t k = 0; k < features.size(); ++k) weights.fetch(blocks.first(k), tiles.reach(k));
  std::fill(q.begin(), q.end(), 0.0);
  std::size_t k = 0;
  for (; k + kTogether <= features.size(); k += kTogether) blocks.add<kTogether>(k, q);
  for (; k < features.size(); ++k) blocks.add<1>(k, q);
}

}  // namespace surefoot
