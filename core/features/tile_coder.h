// SPDX-License-Identifier: GPL-3.0-or-later
// Tile coding (thesis, section 2.3; Sutton & Barto 2018, section 9.5.4) with the displacements of Sutton's tile-coding
// software: tiling i (from 0) of n has, in dimension d (from 0), the tile
//
//   floor((x/width·n + i·(2d + 1)) / n)
//
// that is, each tiling is displaced by the odd numbers 1, 3, 5 … times width/n. n should be a power of two and at
// least 4 per dimension; any n ≥ 1 works. A dense table: every tile of every tiling has a number of its own, and one
// set of numbers serves all actions.
#pragma once

#include <vector>

#include "core/environment.h"
#include "core/features/feature_map.h"

namespace surefoot {

class TileCoder {
 public:
  struct Settings {
    int tilings = 16;
    double scale = 1.0;              ///< multiplies every resolution
    std::vector<double> resolution;  ///< tiles per span, one a state variable

    explicit Settings(const Task& task);
    void declare(Fields& f);

   private:
    std::vector<StateVariable> variables_;
  };

  /// Refused if a wrapping variable has no whole number of tiles, or the table for all actions would be too
  /// large.
  static Result<TileCoder> create(const Task& task, const Settings& settings);

  Index size() const { return size_; }
  int active() const { return tilings_; }
  bool activeFeatures(std::span<const double> state, std::span<Index> out) const;

 private:
  /// One state variable. Positions are counted in whole steps of width/n from the lower edge of the lowest tile; within
  /// a tiling the tile is (position + displacement_i)/n, displacement_i = i·(2d + 1) mod n (whole tiles left out: they
  /// only rename the tiles of a tiling). `carry` holds that sum for position mod `cycle`, multiplied by the stride.
  struct Dimension {
    double scale = 1.0;        // steps per unit of the variable
    double low = 0, high = 0;  // range in steps, clamped to
    double origin = 0;         // the step that is position 0
    Index cycle = 1;           // n; for a wrapping variable n times its tiles
    Index cycleStride = 1;     // what one cycle adds to the feature's number; 0 for a wrapping variable
    bool wraps = false;
    std::vector<Index> carry;  // [position mod cycle][tiling]
  };

  TileCoder() = default;
  static Result<Dimension> layOut(const StateVariable& variable, double tilesPerUnit, int n, double& tiles);

  int tilings_ = 1;
  Index size_ = 0;
  std::vector<Dimension> dimensions_;
  std::vector<Index> tilingStart_;
};

static_assert(FeatureMap<TileCoder>);

}  // namespace surefoot
