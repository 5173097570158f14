// SPDX-License-Identifier: GPL-3.0-or-later
// States that have occurred are found again as poses.
#include "physics/robot/placing.h"

#include "tests/physics/robot/robot_files.h"

namespace surefoot {

namespace {

/// States of random lives, one in so many steps.
std::vector<std::vector<double>> occurred(Robot& robot, int count) {
  Random random(7);
  std::vector<std::vector<double>> states;
  robot.reset(random);
  for (int step = 0; static_cast<int>(states.size()) < count; ++step) {
    const auto action = static_cast<Action>(random.uniform() * static_cast<double>(robot.task().actions.size()));
    if (robot.step(action).ending != Ending::None) robot.reset(random);
    if (step % 7 == 3) states.emplace_back(robot.state().begin(), robot.state().end());
  }
  return states;
}

bool isTouch(const StateSpec& state, const RobotSpec& spec) {
  for (const int place : state.value.expression.variables())
    if (place >= spec.names.firstProbe() &&
        spec.names.probes()[static_cast<std::size_t>(place - spec.names.firstProbe())].what == Probe::What::Touches)
      return true;
  return false;
}

}  // namespace

TEST(RobotPlacing, FindsEveryStateThatOccurred) {
  for (const char* name : {"acrobot", "ball-beam", "biped", "cart-pole", "compass", "hopper", "pendulum", "segway"}) {
    const auto spec = robotOf(robotText(name));
    ASSERT_TRUE(spec);
    Robot robot(spec), other(spec);
    int found = 0;
    double worst = 0.0;
    const auto states = occurred(robot, 100);
    for (const auto& state : states) {
      if (!other.place(state)) continue;
      ++found;
      for (std::size_t s = 0; s < state.size(); ++s) {
        if (isTouch(spec->states[s], *spec)) continue;
        const double range = other.task().state[s].high - other.task().state[s].low;
        double off = other.state()[s] - state[s];
        if (const auto period = other.task().state[s].period) off -= *period * std::floor(off / *period + 0.5);
        worst = std::max(worst, std::abs(off) / range);
      }
    }
    EXPECT_EQ(found, static_cast<int>(states.size())) << name;
    EXPECT_LT(worst, Placing::kNear) << name;
  }
}

}  // namespace surefoot
