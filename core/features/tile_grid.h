// SPDX-License-Identifier: GPL-3.0-or-later
// Tile coding (thesis, section 2.3; Sutton & Barto 2018, section 9.5.4) with the displacements of Sutton's tile-coding
// software: tiling i (from 0) of n has, in dimension d (from 0), the tile
//
//   floor((x/width·n + i·(2d + 1)) / n)
//
// that is, each tiling is displaced by the odd numbers 1, 3, 5 … times width/n. n should be a power of two and at
// least 4 per dimension; any n ≥ 1 works. Here every tile of every tiling gets a number of its own; TileCoder (a dense
// table) and HashedTileCoder turn this number into a feature. The tiling counts fastest, because a state lies in tiles
// of the same place in most tilings: so the weights of a state lie together in memory.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "core/features/feature_map.h"
#include "core/features/tile_settings.h"

namespace surefoot {

/// `Number` is wide enough for all tiles: 32 bits where there is a table for them, 64 where they are hashed.
template <class Number>
class TileGrid {
 public:
  /// Refused if a wrapping variable has no whole number of tiles, a box is empty, or there are more than `mostTiles`.
  static Result<TileGrid> create(const Task& task, const TileSettings& settings, double mostTiles);

  Number size() const { return size_; }
  int tilings() const { return tilings_; }
  /// out ← the number of the tile of each tiling; `out` is as long as there are tilings. Hot.
  Cover find(std::span<const double> state, std::span<Number> out) const;
  nlohmann::json layout() const;
  /// Tiles along each dimension, the last dimension first, then tilings.
  std::vector<std::size_t> shape() const;

 private:
  /// One state variable. Positions are counted in whole steps of width/n from the lower edge of the lowest tile; within
  /// a tiling the tile is (position + displacement_i)/n, displacement_i = i·(2d + 1) mod n (whole tiles left out: they
  /// only rename the tiles of a tiling). `carry` holds that sum for position mod `cycle`, multiplied by the stride.
  struct Dimension {
    std::string key;
    double scale = 1.0;        // steps per unit of the variable
    double low = 0, high = 0;  // range in steps; states are clamped to it
    double origin = 0;         // the step that is position 0
    double tiles = 0;          // number of tiles of a tiling, displaced ones included
    Number cycle = 1;          // n; for a wrapping variable n times its tiles
    int shift = -1;            // log₂ of cycle, if that is whole: no division then
    Number cycleStride = 1;    // what one cycle adds to the tile's number; 0 for a wrapping variable
    bool wraps = false;
    bool closedBelow = false, closedAbove = false;  // a box: beyond it there is nothing
    double from = 0, to = 0;                        // the ends of the box
    std::vector<Number> carry;                      // [position mod cycle][tiling]
  };

  TileGrid() = default;
  static Result<Dimension> layOut(const StateVariable& variable, const TileSettings& settings, std::size_t d);

  int tilings_ = 1;
  Number size_ = 0;
  std::vector<Dimension> dimensions_;
};

extern template class TileGrid<std::uint32_t>;
extern template class TileGrid<std::uint64_t>;

}  // namespace surefoot
