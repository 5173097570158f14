// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environments/grid.h"

namespace surefoot {

StateVariable cellVariable(const std::string& key, double low, double high) {
  return {.key = key,
          .title = key,
          .low = low,
          .high = high,
          .span = 1.0,
          .spanText = "cell",
          .perSpan = "/cell",
          .resolution = 1.0,
          .whole = true,
          .viewLow = low - 0.5,
          .viewHigh = high + 0.5};
}

void Grid::describe(Task& task) const {
  task.state = {cellVariable("column", 0, columns - 1.0), cellVariable("row", 0, rows - 1.0)};
  task.actions = {Up, Down, Left, Right};
  task.actionNames = {"up", "down", "left", "right"};
  task.actionTitle = "move";
}

void Grid::drawLines(Scene& scene) const {
  scene.clear();
  scene.focus = {columns / 2.0, 0};
  scene.height = rows;
  scene.width = columns;
  scene.metres = false;
  for (double row = 0; row <= rows; ++row)
    scene.shapes.push_back(Polyline{{{0, row}, {columns + 0.0, row}}, Ink::Outline, 1});
  for (double column = 0; column <= columns; ++column)
    scene.shapes.push_back(Polyline{{{column, 0}, {column, rows + 0.0}}, Ink::Outline, 1});
}

void Grid::drawWalker(Scene& scene, std::span<const double> pose) const {
  scene.tip = {pose[Column] + 0.5, pose[Row] + 0.5};
  scene.shapes.push_back(Disc{scene.tip, 0.28, Fill::Solid, Ink::Body, 2});
}

}  // namespace surefoot
