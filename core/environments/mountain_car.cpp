// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environments/mountain_car.h"

#include <algorithm>

#include "core/basics/portable_math.h"

namespace surefoot {

namespace {

/// The height of the hill whose slope pulls as the equation says, up to a factor: sin 3x.
double hill(double x) {
  return portableCos(3 * x - 1.5707963267948966);
}

}  // namespace

MountainCar::MountainCar() {
  task_.state = {{.key = "position",
                  .title = "position",
                  .symbol = "x",
                  .unit = "",
                  .low = kLeft,
                  .high = kGoal,
                  .span = kGoal - kLeft,
                  .spanText = "the whole range",
                  .perSpan = "",
                  .resolution = 8,
                  .viewLow = kLeft,
                  .viewHigh = kGoal},
                 {.key = "velocity",
                  .title = "velocity",
                  .symbol = "x\u0307",
                  .unit = "",
                  .low = -kFastest,
                  .high = kFastest,
                  .span = 2 * kFastest,
                  .spanText = "the whole range",
                  .perSpan = "",
                  .resolution = 8,
                  .viewLow = -kFastest,
                  .viewHigh = kFastest}};
  task_.actions = {-1, 0, 1};
  task_.actionNames = {"reverse", "none", "forward"};
  task_.actionTitle = "throttle";
  task_.rewardTerms = {"time"};
  task_.canFall = false;
  task_.lowestReturn = -500;
  task_.highestReturn = 0;
}

void MountainCar::reset(Random& random) {
  resetTo(random.uniform(-0.6, -0.4), 0.0);
}

void MountainCar::resetTo(double position, double velocity) {
  state_ = {position, velocity};
  limit_.steps = 0;
}

Outcome MountainCar::step(Action action) {
  auto& [x, v] = state_;
  v = std::clamp(v + 0.001 * task_.actions[static_cast<std::size_t>(action)] - 0.0025 * portableCos(3 * x), -kFastest,
                 kFastest);
  x = std::clamp(x + v, kLeft, kGoal);
  if (x == kLeft) v = 0.0;
  Outcome outcome;
  outcome.reward = outcome.terms[0] = -1.0;
  if (x >= kGoal) {
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Success;
  }
  limit_.count(outcome);
  return outcome;
}

void MountainCar::draw(std::span<const double> pose, Scene& scene) const {
  constexpr double kAmplitude = 0.35, kBase = 0.4;
  scene.clear();
  scene.focus = {(kLeft + kGoal) / 2, 0};
  scene.height = 1.0;
  scene.width = kGoal - kLeft + 0.2;
  scene.metres = false;
  Polyline ground{.points = {}, .ink = Ink::Solid, .width = 2};
  constexpr int kPieces = 100;
  for (int i = 0; i <= kPieces; ++i) {
    const double x = kLeft + (kGoal - kLeft) * i / kPieces;
    ground.points.push_back({x, kBase + kAmplitude * hill(x)});
  }
  scene.shapes.push_back(ground);
  const double top = kBase + kAmplitude * hill(kGoal);
  scene.shapes.push_back(Polyline{{{kGoal, top}, {kGoal, top + 0.15}}, Ink::Solid, 1.5});
  scene.shapes.push_back(Label{{kGoal, top + 0.15}, "goal", 0, -10, 0, Ink::Quiet});
  scene.tip = {pose[0], kBase + kAmplitude * hill(pose[0]) + 0.04};
  scene.shapes.push_back(Disc{scene.tip, 0.04, Fill::Solid, Ink::Body, 2});
}

std::vector<ReadOut> MountainCar::readOuts(std::span<const double> pose) const {
  return {{"x", "", pose[0], 3}, {"x\u0307", "", pose[1], 4}};
}

}  // namespace surefoot
