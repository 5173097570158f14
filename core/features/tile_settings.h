// SPDX-License-Identifier: GPL-3.0-or-later
// What can be set of a tile coder, and of one in a hashed table.
#pragma once

#include <vector>

#include "core/environment.h"

namespace surefoot {

struct TileSettings {
  static constexpr int kMostTilings = 128;

  int tilings = 16;
  double scale = 1.0;              ///< multiplies every resolution
  int memory = 0;                  ///< tiles that a hashed table holds; 0: a dense table, every tile has its place
  std::vector<double> resolution;  ///< tiles per span, one a state variable
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
