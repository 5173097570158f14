// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/tile_layout.h"

#include <cmath>

namespace surefoot {

std::optional<TileLayout> TileLayout::fromJson(const nlohmann::json& layout) {
  if (!layout.is_object() || !layout.contains("tilings") || !layout.contains("variables")) return std::nullopt;
  TileLayout tiles;
  tiles.tilings_ = layout["tilings"];
  for (const auto& v : layout["variables"]) {
    if (!v.contains("steps_per_unit")) return std::nullopt;
    const bool hashed = !v.contains("origin_step");
    tiles.axes_.push_back({v.value("tiles", 0.0), v["steps_per_unit"], hashed ? 0.0 : v["origin_step"].get<double>(),
                           v.value("displacement", 1.0)});
  }
  return tiles;
}

double TileLayout::shift(std::size_t d, int i) const {
  return std::fmod(i * axes_[d].displacement, tilings_);
}

double TileLayout::edge(std::size_t d, int i, double k) const {
  return (axes_[d].origin + k * tilings_ - shift(d, i)) / axes_[d].perUnit;
}

std::pair<double, double> TileLayout::tileAt(std::size_t d, int i, double value) const {
  const double k = std::floor((value * axes_[d].perUnit - axes_[d].origin + shift(d, i)) / tilings_);
  return {edge(d, i, k), edge(d, i, k + 1)};
}

}  // namespace surefoot
