// SPDX-License-Identifier: GPL-3.0-or-later
// Tile coding over a hashed table of fixed memory (Sutton & Barto 2018, section 9.5.4), for worlds with more tiles than
// memory, of which only few are ever visited. A tile gets a slot when a learner first comes to it: the first free one
// from its hash on (open addressing). Features are numbered in the order in which their tiles were claimed, so that
// what belongs to them grows from the front of a table. After kMostProbes slots taken by others the look-up has failed:
// the tile then shares the feature of the slot of its hash. Looking at a state that no learner has been to claims
// nothing: it is answered with the numbers that its tiles would get.
#pragma once

#include "core/features/action_tiles.h"
#include "core/features/tile_grid.h"

namespace surefoot {

class HashedTileCoder {
 public:
  using Active = ActiveFeatures<TileSettings::kMostTilings, true>;
  static constexpr bool kBinary = true;
  static constexpr int kMostProbes = 64;

  /// `settings.memory` slots, at least one. Refused as by TileGrid, or if the table would be too large.
  static Result<HashedTileCoder> create(const Task& task, const TileSettings& settings);

  Index size() const { return static_cast<Index>(features_.size()); }
  double total() const { return grid_.tilings(); }
  const ActionTiles& actionTiles() const { return actionTiles_; }
  Cover find(std::span<const double> state, Active& x) const;
  Cover claim(std::span<const double> state, Active& x);
  nlohmann::json layout() const;
  std::vector<std::size_t> shape() const { return {features_.size()}; }

  /// [feature] the tile of every claimed feature.
  std::span<const std::uint64_t> tiles() const { return tiles_; }
  /// Claims these tiles, in this order, and forgets all others: at most size(), none of them twice.
  Status setTiles(std::span<const std::uint64_t> tiles);
  /// Features that are claimed: 0 … occupied() − 1.
  Index occupied() const { return static_cast<Index>(tiles_.size()); }
  std::int64_t failedLookUps() const { return failed_; }
  void setFailedLookUps(std::int64_t failed) { failed_ = failed; }

 private:
  HashedTileCoder(TileGrid<std::uint64_t> grid, ActionTiles actionTiles, std::size_t slots)
      : grid_(std::move(grid)),
        actionTiles_(std::move(actionTiles)),
        features_(slots, kFree) {
    tiles_.reserve(slots);
  }
  static constexpr Index kFree = ~Index{0};
  struct Probe {
    Index slot;
    bool free, failed;
  };
  Probe probe(std::uint64_t tile) const;

  TileGrid<std::uint64_t> grid_;
  ActionTiles actionTiles_;
  std::vector<Index> features_;       // [slot]
  std::vector<std::uint64_t> tiles_;  // [feature]; its memory is reserved from the start
  std::int64_t failed_ = 0;
};

static_assert(ClaimingFeatureMap<HashedTileCoder>);

}  // namespace surefoot
