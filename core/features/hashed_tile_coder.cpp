// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/hashed_tile_coder.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/basics/random.h"
#include "core/features/resolution.h"

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
  const auto slots = static_cast<std::uint64_t>(features_.size());
  const auto home = static_cast<Index>(mix64(tile + 0x9e3779b97f4a7c15ULL) % slots);
  Index slot = home;
  for (int i = 0; i < kMostProbes; ++i) {
    const Index feature = features_[slot];
    if (feature == kFree) return {slot, true, false};
    if (tiles_[feature] == tile) return {slot, false, false};
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
  Index next = occupied();
  for (std::size_t i = 0; i < n; ++i) {
    const Probe found = probe(tiles[i]);
    x.index[i] = found.free ? std::min(next++, size() - 1) : features_[found.slot];
  }
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
    if (found.free) features_[found.slot] = occupied(), tiles_.push_back(tiles[i]);
    failed_ += found.failed;
    x.index[i] = features_[found.slot];
  }
  return cover;
}

Status HashedTileCoder::setTiles(std::span<const std::uint64_t> tiles) {
  std::fill(features_.begin(), features_.end(), kFree);
  tiles_.clear();
  for (const std::uint64_t tile : tiles) {
    const Probe found = probe(tile);
    if (!found.free) return Error{"names a tile twice, or more than fit"};
    features_[found.slot] = occupied();
    tiles_.push_back(tile);
  }
  return Done{};
}

nlohmann::json HashedTileCoder::layout() const {
  nlohmann::json layout = grid_.layout();
  layout["kind"] = "hashed-tile-coder";
  layout["memory"] = features_.size();
  if (actionTiles_.shared()) layout["action_tiles"] = actionTiles_.layout();
  return layout;
}

}  // namespace surefoot
