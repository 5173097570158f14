// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environments/grid_world.h"

namespace surefoot {

namespace {
struct GridTerms {
  enum Term { Goal, Fall };
};
constexpr double kGridReward = 100.0;
}  // namespace

GridWorld::GridWorld() {
  kGrid.describe(task_);
  task_.rewardTerms = {"goal", "fall"};
  task_.goalReward = kGridReward;
  task_.lowestReturn = -kGridReward;
  task_.highestReturn = kGridReward;
}

void GridWorld::reset(Random&) {
  resetTo(0, 0);
}

void GridWorld::resetTo(double column, double row) {
  state_ = {column, row};
  limit_.steps = 0;
}

Outcome GridWorld::step(Action action) {
  kGrid.move(state_, action);
  Outcome outcome;
  const auto [column, row] = state_;
  if (column == kGrid.columns - 1.0 && row == kGrid.rows - 1.0) {
    outcome.reward = outcome.terms[GridTerms::Goal] = kGridReward;
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Success;
  } else if (column >= kBadLeft && column <= kBadRight && row >= kBadBottom && row <= kBadTop) {
    outcome.reward = outcome.terms[GridTerms::Fall] = -kGridReward;
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Fall;
  }
  limit_.count(outcome);
  return outcome;
}

void GridWorld::draw(std::span<const double> pose, Scene& scene) const {
  constexpr double kLeft = kBadLeft, kRight = kBadRight + 1, kBottom = kBadBottom, kTop = kBadTop + 1;
  kGrid.drawLines(scene);
  scene.shapes.push_back(Polygon{.points = {{kLeft, kBottom}, {kRight, kBottom}, {kRight, kTop}, {kLeft, kTop}},
                                 .fill = Fill::Fall,
                                 .ink = Ink::Fall,
                                 .width = 0});
  const Point middle{(kLeft + kRight) / 2, (kBottom + kTop) / 2};
  scene.shapes.push_back(Label{middle, "fall", 0, 0, 0, Ink::Fall, false, kRight - kLeft});
  scene.shapes.push_back(Label{{0.5, 0}, "start", 0, 9});
  scene.shapes.push_back(Label{{kGrid.columns - 0.5, kGrid.rows}, "goal", 0, -9});
  kGrid.drawWalker(scene, pose);
}

std::vector<ReadOut> GridWorld::readOuts(std::span<const double> pose) const {
  return {{"column", "", pose[Grid::Column], 0}, {"row", "", pose[Grid::Row], 0}};
}

}  // namespace surefoot
