// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/tile_coder.h"

#include <nlohmann/json.hpp>

#include "core/features/resolution.h"

namespace surefoot {

Result<TileCoder> TileCoder::create(const Task& task, const TileSettings& settings) {
  auto grid = TileGrid<Index>::create(task, settings, kMostWeights / static_cast<double>(task.actions.size()));
  if (!grid) return grid.error();
  return TileCoder(std::move(*grid));
}

nlohmann::json TileCoder::layout() const {
  return grid_.layout();
}

}  // namespace surefoot
