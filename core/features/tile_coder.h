// SPDX-License-Identifier: GPL-3.0-or-later
// Tile coding over a dense table: every tile of every tiling is a feature, and one set of numbers serves all actions.
#pragma once

#include "core/features/action_tiles.h"
#include "core/features/tile_grid.h"

namespace surefoot {

class TileCoder {
 public:
  using Settings = TileSettings;
  using Active = ActiveFeatures<TileSettings::kMostTilings, true>;
  static constexpr bool kBinary = true;

  /// Refused as by TileGrid, or if the table for all actions would be too large.
  static Result<TileCoder> create(const Task& task, const TileSettings& settings);

  Index size() const { return grid_.size(); }
  double total() const { return grid_.tilings(); }
  const ActionTiles& actionTiles() const { return actionTiles_; }
  Cover find(std::span<const double> state, Active& x) const {
    x.count = grid_.tilings();
    const Cover cover = grid_.find(state, {x.index.data(), static_cast<std::size_t>(x.count)});
    if (cover == Cover::Nothing) x.count = 0;
    return cover;
  }
  nlohmann::json layout() const;
  std::vector<std::size_t> shape() const { return grid_.shape(); }

 private:
  TileCoder(TileGrid<Index> grid, ActionTiles actionTiles)
      : grid_(std::move(grid)),
        actionTiles_(std::move(actionTiles)) {}
  TileGrid<Index> grid_;
  ActionTiles actionTiles_;
};

static_assert(FeatureMap<TileCoder>);

}  // namespace surefoot
