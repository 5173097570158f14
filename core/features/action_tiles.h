// SPDX-License-Identifier: GPL-3.0-or-later
// Tiles over actions that are combinations of several variables (Task::actionVariables). In tiling i an action lies, in
// action variable j, in the tile floor(((u − u_min)/width·n + i·(2d + 1) mod n) / n), with d counting on from the state
// variables, so that actions which are near share weights in most tilings and tell themselves apart in some. The tiles
// of all action variables together are the columns of a block of weights: one look-up of a state's tile serves all
// actions.
//
// Without action variables every action has a column of its own in every tiling.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/features/tile_settings.h"

namespace surefoot {

class ActionTiles {
 public:
  static constexpr std::size_t kMostColumns = 4096;  // columns of a block

  /// An action variable with its levels and how many tiles lie in a unit of it.
  struct Variable {
    std::string key;
    std::vector<double> levels;
    double tilesPerUnit = 1.0;
  };

  static Result<ActionTiles> create(const Task& task, const TileSettings& settings);
  /// The same from numbers alone; without variables each action has a column of its own.
  static Result<ActionTiles> create(std::size_t stateVariables, std::size_t tilings, std::size_t actions,
                                    const std::vector<Variable>& variables);

  /// Whether actions share columns.
  bool shared() const { return !columns_.empty(); }
  /// Weights of a feature.
  std::size_t count() const { return count_; }
  /// [action] in a tiling; only where shared().
  std::span<const std::uint16_t> columnsOf(std::size_t tiling) const {
    return {columns_.data() + tiling * actions_, actions_};
  }
  /// All columns of a tiling are below this; only where shared().
  std::size_t reach(std::size_t tiling) const { return reach_[tiling]; }
  std::size_t column(std::size_t tiling, int action) const {
    const auto a = static_cast<std::size_t>(action);
    return shared() ? columns_[tiling * actions_ + a] : a;
  }
  /// null if actions do not share weights.
  nlohmann::json layout() const { return layout_; }

 private:
  std::size_t actions_ = 0, count_ = 0;
  std::vector<std::uint16_t> columns_;  // [tiling][action]; empty: each its own
  std::vector<std::uint16_t> reach_;    // [tiling]
  nlohmann::json layout_;
};

}  // namespace surefoot
