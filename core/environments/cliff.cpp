// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environments/cliff.h"

#include <algorithm>

namespace surefoot {

namespace {
enum RewardTerm { kTime, kFall };
enum Coordinate { kColumn, kRow };
}  // namespace

Cliff::Cliff() {
  const auto variable = [](const char* key, int count) {
    return StateVariable{.key = key,
                         .title = key,
                         .symbol = "",
                         .unit = "",
                         .low = 0.0,
                         .high = count - 1.0,
                         .span = 1.0,
                         .spanText = "cell",
                         .perSpan = "/cell",
                         .resolution = 1.0,
                         .whole = true,
                         .viewLow = -0.5,
                         .viewHigh = count - 0.5};
  };
  task_.state = {variable("column", kColumns), variable("row", kRows)};
  task_.actions = {0, 1, 2, 3};
  task_.actionNames = {"up", "down", "left", "right"};
  task_.actionTitle = "move";
  task_.rewardTerms = {"time", "fall"};
  task_.lowestReturn = -100;
  task_.highestReturn = 0;
}

void Cliff::reset(Random&) {
  state_ = {0.0, 0.0};
  limit_.steps = 0;
}

Outcome Cliff::step(Action action) {
  constexpr int kRight[] = {0, 0, -1, 1}, kUp[] = {1, -1, 0, 0};
  state_[kColumn] = std::clamp(state_[kColumn] + kRight[action], 0.0, kColumns - 1.0);
  state_[kRow] = std::clamp(state_[kRow] + kUp[action], 0.0, kRows - 1.0);
  ++limit_.steps;
  Outcome outcome;
  outcome.terms[kTime] = -1.0;
  if (state_[kRow] == 0.0 && state_[kColumn] == kColumns - 1.0) {
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Success;
  } else if (state_[kRow] == 0.0 && state_[kColumn] > 0.0) {
    outcome.terms[kTime] = 0.0;
    outcome.terms[kFall] = -100.0;
    outcome.event = Event::Fall;
    state_ = {0.0, 0.0};
  }
  if (outcome.ending == Ending::None && limit_.steps >= limit_.most) outcome.ending = Ending::Truncated;
  outcome.reward = outcome.terms[kTime] + outcome.terms[kFall];
  return outcome;
}

void Cliff::draw(std::span<const double> pose, Scene& scene) const {
  scene.clear();
  scene.focus = {kColumns / 2.0, 0};
  scene.height = kRows;
  scene.width = kColumns;
  scene.metres = false;
  const Polygon cliff{.points = {{1, 0}, {kColumns - 1.0, 0}, {kColumns - 1.0, 1}, {1, 1}},
                      .fill = Fill::Fall,
                      .ink = Ink::Fall,
                      .width = 0};
  scene.shapes.emplace_back(cliff);
  for (int row = 0; row <= kRows; ++row)
    scene.shapes.push_back(Polyline{{{0, row + 0.0}, {kColumns, row + 0.0}}, Ink::Outline, 1});
  for (int column = 0; column <= kColumns; ++column)
    scene.shapes.push_back(Polyline{{{column + 0.0, 0}, {column + 0.0, kRows}}, Ink::Outline, 1});
  scene.shapes.push_back(Label{{kColumns / 2.0, 0.5}, "cliff", 0, 0, 0, Ink::Fall});
  scene.shapes.push_back(Label{{0.5, 0.5}, "start", 0, 0, 0, Ink::Quiet});
  scene.shapes.push_back(Label{{kColumns - 0.5, 0.5}, "goal", 0, 0, 0, Ink::Quiet});
  scene.tip = {pose[kColumn] + 0.5, pose[kRow] + 0.5};
  scene.shapes.push_back(Disc{scene.tip, 0.28, Fill::Solid, Ink::Body, 2});
}

std::vector<ReadOut> Cliff::readOuts(std::span<const double> pose) const {
  return {{"column", "", pose[kColumn], 0}, {"row", "", pose[kRow], 0}};
}

}  // namespace surefoot
