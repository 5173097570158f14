// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/hashed_tile_coder.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/features/resolution.h"
#include "core/random.h"

namespace surefoot {

Result<HashedTileCoder> HashedTileCoder::create(const Task& task, const TileSettings& settings) {
  constexpr double kMostTiles = 4e18;  // a number fits 62 bits
  auto grid = TileGrid<std::uint64_t>::create(task, settings, kMostTiles);
  if (!grid) return grid.error();
  auto actionTiles = ActionTiles::create(task, settings);
  if (!actionTiles) return actionTiles.error();
  const double weights = settings.memory * static_cast<double>(actionTiles->count());
  if (weights > kMostWeights)
    return Error{fmt::format(
        "features.memory = {}: with {} weights a tile that is a table of {:.3g} weights; at most {:.3g} are "
        "allowed.",
        settings.memory, actionTiles->count(), weights, kMostWeights)};
  return HashedTileCoder(std::move(*grid), std::move(*actionTiles), static_cast<std::size_t>(settings.memory));
}

HashedTileCoder::Probe HashedTileCoder::probe(std::uint64_t tile) const {
  const auto slots = static_cast<std::uint64_t>(tiles_.size());
  const auto home = static_cast<Index>(mix64(tile + 0x9e3779b97f4a7c15ULL) % slots);
  Index slot = home;
  for (int i = 0; i < kMostProbes; ++i) {
    if (tiles_[slot] == tile + 1) return {slot, false, false};
    if (tiles_[slot] == 0) return {slot, true, false};
    if (++slot == slots) slot = 0;
  }
  return {home, false, true};
}

Cover HashedTileCoder::find(std::span<const double> state, Active& x) const {
  std::array<std::uint64_t, TileSettings::kMostTilings> tiles;
  x.count = grid_.tilings();
  const auto n = static_cast<std::size_t>(x.count);
  const Cover cover = grid_.find(state, std::span(tiles.data(), n));
  if (cover == Cover::Nothing) return x.count = 0, cover;
  for (std::size_t i = 0; i < n; ++i) x.index[i] = probe(tiles[i]).slot;
  return cover;
}

Cover HashedTileCoder::claim(std::span<const double> state, Active& x) {
  std::array<std::uint64_t, TileSettings::kMostTilings> tiles;
  x.count = grid_.tilings();
  const auto n = static_cast<std::size_t>(x.count);
  const Cover cover = grid_.find(state, std::span(tiles.data(), n));
  if (cover == Cover::Nothing) return x.count = 0, cover;
  for (std::size_t i = 0; i < n; ++i) {
    const Probe found = probe(tiles[i]);
    if (found.free) tiles_[found.slot] = tiles[i] + 1, ++occupied_;
    failed_ += found.failed;
    x.index[i] = found.slot;
  }
  return cover;
}

void HashedTileCoder::setTiles(std::span<const std::uint64_t> tiles) {
  std::copy(tiles.begin(), tiles.end(), tiles_.begin());
  occupied_ = static_cast<Index>(std::count_if(tiles_.begin(), tiles_.end(), [](std::uint64_t t) { return t != 0; }));
}

nlohmann::json HashedTileCoder::layout() const {
  nlohmann::json layout = grid_.layout();
  layout["kind"] = "hashed-tile-coder";
  layout["memory"] = tiles_.size();
  if (actionTiles_.shared()) layout["action_tiles"] = actionTiles_.layout();
  return layout;
}

}  // namespace surefoot
