// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by worlds of cells: a position, four moves that stop at the walls, and a picture. Column and row count from
// 0, the row from the bottom.
#pragma once

#include <algorithm>
#include <array>
#include <string>

#include "core/environment.h"

namespace surefoot {

struct Grid {
  enum Move : Action { Up, Down, Left, Right };
  enum Coordinate : std::size_t { Column, Row };

  int columns = 1, rows = 1;

  /// The state variables and the actions of a task in this grid.
  void describe(Task& task) const;
  /// One cell on, if there is no wall.
  void move(std::array<double, 2>& at, Action action) const {
    constexpr int kRight[] = {0, 0, -1, 1}, kUp[] = {1, -1, 0, 0};
    at[Column] = std::clamp(at[Column] + kRight[action], 0.0, columns - 1.0);
    at[Row] = std::clamp(at[Row] + kUp[action], 0.0, rows - 1.0);
  }
  /// Lines, on an empty scene.
  void drawLines(Scene& scene) const;
  /// The walker; above everything else.
  void drawWalker(Scene& scene, std::span<const double> pose) const;
};

/// A state variable that takes the whole numbers `low` … `high`.
StateVariable cellVariable(const std::string& key, double low, double high);

}  // namespace surefoot
