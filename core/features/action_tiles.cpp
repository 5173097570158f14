// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/action_tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace surefoot {

Result<ActionTiles> ActionTiles::create(const Task& task, const TileSettings& settings) {
  std::vector<Variable> variables;
  for (std::size_t j = 0; j < task.actionVariables.size(); ++j) {
    const ActionVariable& v = task.actionVariables[j];
    variables.push_back({v.key, {v.levels.begin(), v.levels.end()}, settings.actionTilesPerUnit(j)});
  }
  return create(task.state.size(), static_cast<std::size_t>(settings.tilings), task.actions.size(), variables);
}

Result<ActionTiles> ActionTiles::create(std::size_t stateVariables, std::size_t n, std::size_t actions,
                                        const std::vector<Variable>& variables) {
  ActionTiles tiles;
  tiles.actions_ = tiles.count_ = actions;
  if (variables.empty()) return tiles;

  tiles.count_ = 1;
  tiles.columns_.assign(n * tiles.actions_, 0);
  tiles.layout_ = nlohmann::json::array();
  std::size_t repeat = tiles.actions_;  // actions in a row that have one level of this variable
  for (std::size_t j = 0; j < variables.size(); ++j) {
    const Variable& v = variables[j];
    repeat /= v.levels.size();
    const double stepsPerUnit = v.tilesPerUnit * static_cast<double>(n);
    const auto tileOf = [&](std::size_t tiling, double level) {
      const auto position = static_cast<std::size_t>(std::floor((level - v.levels.front()) * stepsPerUnit + 1e-9));
      const std::size_t displacement = tiling * (2 * (stateVariables + j) + 1) % n;
      return (position + displacement) / n;
    };
    const std::size_t along = tileOf(n - 1, v.levels.back()) + 2;  // whatever the displacement
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t a = 0; a < tiles.actions_; ++a) {
        auto& column = tiles.columns_[i * tiles.actions_ + a];
        column = static_cast<std::uint16_t>(column * along + tileOf(i, v.levels[a / repeat % v.levels.size()]));
      }
    tiles.count_ *= along;
    if (tiles.count_ > kMostColumns)
      return Error{fmt::format("features.{}: with it an action has {} tiles; at most {} are allowed.", v.key,
                               tiles.count_, kMostColumns)};
    tiles.layout_.push_back({{"variable", v.key}, {"tiles_per_unit", v.tilesPerUnit}, {"levels", v.levels}});
  }
  // Only columns that some action has, so that a block is as small as it can be.
  std::vector<std::uint16_t> names(tiles.count_, 0);
  std::uint16_t used = 0;
  for (std::uint16_t& column : tiles.columns_) {
    if (names[column] == 0) names[column] = ++used;
    column = static_cast<std::uint16_t>(names[column] - 1);
  }
  tiles.count_ = used;
  for (std::size_t i = 0; i < n; ++i) {
    const auto columns = tiles.columnsOf(i);
    tiles.reach_.push_back(static_cast<std::uint16_t>(*std::max_element(columns.begin(), columns.end()) + 1));
  }
  return tiles;
}

}  // namespace surefoot
