// SPDX-License-Identifier: GPL-3.0-or-later
// Where the tiles of a tile coder lie, read from its description (TileGrid::layout): for pictures, not for learning.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace surefoot {

class TileLayout {
 public:
  /// Empty if the description is not of a tile coder.
  static std::optional<TileLayout> fromJson(const nlohmann::json& layout);

  int tilings() const { return tilings_; }
  std::size_t dimensions() const { return axes_.size(); }
  /// Tiles of a tiling along dimension d.
  double tiles(std::size_t d) const { return axes_[d].tiles; }
  /// The k-th edge of tiling i along dimension d, in units of the variable.
  double edge(std::size_t d, int i, double k) const;
  /// Both edges of the tile of tiling i that holds a value.
  std::pair<double, double> tileAt(std::size_t d, int i, double value) const;
  double width(std::size_t d) const { return tilings_ / axes_[d].perUnit; }

 private:
  struct Axis {
    double tiles, perUnit, origin, displacement;  // the last three in steps of width/tilings
  };
  double shift(std::size_t d, int i) const;

  int tilings_ = 1;
  std::vector<Axis> axes_;
};

}  // namespace surefoot
