// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environments/cliff.h"

namespace surefoot {

namespace {
struct CliffTerms {
  enum Term { Time, Fall };
};
}  // namespace

Cliff::Cliff() {
  kGrid.describe(task_);
  task_.rewardTerms = {"time", "fall"};
  task_.lowestReturn = -100;
  task_.highestReturn = 0;
}

void Cliff::reset(Random&) {
  state_ = {0.0, 0.0};
  limit_.steps = 0;
}

Outcome Cliff::step(Action action) {
  constexpr double kGoal = kGrid.columns - 1.0;
  kGrid.move(state_, action);
  Outcome outcome;
  outcome.terms[CliffTerms::Time] = -1.0;
  const auto [column, row] = state_;
  if (row == 0.0 && column == kGoal) {
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Success;
  } else if (row == 0.0 && column > 0.0) {
    outcome.terms[CliffTerms::Time] = 0.0;
    outcome.terms[CliffTerms::Fall] = -100.0;
    outcome.event = Event::Fall;
    state_ = {0.0, 0.0};
  }
  outcome.reward = outcome.terms[CliffTerms::Time] + outcome.terms[CliffTerms::Fall];
  limit_.count(outcome);
  return outcome;
}

void Cliff::draw(std::span<const double> pose, Scene& scene) const {
  constexpr double kEnd = kGrid.columns;
  kGrid.drawLines(scene);
  scene.shapes.push_back(Polygon{
      .points = {{1, 0}, {kEnd - 1, 0}, {kEnd - 1, 1}, {1, 1}}, .fill = Fill::Fall, .ink = Ink::Fall, .width = 0});
  scene.shapes.push_back(Label{{kEnd / 2, 0.5}, "cliff", 0, 0, 0, Ink::Fall, false, kEnd - 2});
  scene.shapes.push_back(Label{{0.5, 0}, "start", 0, 9});
  scene.shapes.push_back(Label{{kEnd - 0.5, 0}, "goal", 0, 9});
  kGrid.drawWalker(scene, pose);
}

std::vector<ReadOut> Cliff::readOuts(std::span<const double> pose) const {
  return {{"column", "", pose[Grid::Column], 0}, {"row", "", pose[Grid::Row], 0}};
}

}  // namespace surefoot
