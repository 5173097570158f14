// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of a tile coder, with a dense or a hashed table.
#pragma once

#include <vector>

#include "core/environment.h"

namespace surefoot {

struct TileSettings {
  static constexpr int kMostTilings = 128;

  int tilings = 16;
  double scale = 1.0;                    ///< multiplies every resolution
  int memory = 0;                        ///< slots of a hashed table; 0: a dense table, where every tile has a place
  std::vector<double> resolution;        ///< tiles per span, one a state variable
  std::vector<double> actionResolution;  ///< tiles per unit, one an action variable
  std::vector<double> from, to;          ///< the box that is covered; outside it no tile is on

  explicit TileSettings(const Task& task);
  void declare(Fields& f);
  /// Tiles per unit of variable `d`.
  double tilesPerUnit(std::size_t d) const { return resolution[d] * scale / variables_[d].span; }
  double actionTilesPerUnit(std::size_t j) const { return actionResolution[j] * scale; }

 private:
  std::vector<StateVariable> variables_;
  std::vector<ActionVariable> actionVariables_;
};

}  // namespace surefoot
