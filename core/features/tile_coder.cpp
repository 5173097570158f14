// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/tile_coder.h"

#include <nlohmann/json.hpp>

#include "core/features/resolution.h"

namespace surefoot {

Result<TileCoder> TileCoder::create(const Task& task, const TileSettings& settings) {
  auto actionTiles = ActionTiles::create(task, settings);
  if (!actionTiles) return actionTiles.error();
  auto grid = TileGrid<Index>::create(task, settings, kMostWeights / static_cast<double>(actionTiles->count()));
  if (!grid) return grid.error();
  return TileCoder(std::move(*grid), std::move(*actionTiles));
}

nlohmann::json TileCoder::layout() const {
  nlohmann::json layout = grid_.layout();
  if (actionTiles_.shared()) layout["action_tiles"] = actionTiles_.layout();
  return layout;
}

}  // namespace surefoot
