// SPDX-License-Identifier: GPL-3.0-or-later
// What a robot from a file tells of its motion, held against the same robot that is compiled in.
#include <cmath>
#include <map>

#include "tests/physics/robot/robot_files.h"

namespace surefoot {

namespace {

std::map<std::string, double> signalsNow(const Environment& environment) {
  const std::vector<Signal> all = environment.signals();
  std::vector<double> values(all.size(), std::nan(""));
  environment.readSignals(values);
  std::map<std::string, double> named;
  for (std::size_t i = 0; i < all.size(); ++i) named[all[i].key] = values[i];
  EXPECT_EQ(named.size(), all.size()) << "every key once";
  return named;
}

}  // namespace

TEST(RobotSignals, OfThePendulumAreThoseOfTheCompiledOne) {
  const Registry registry = fullRegistry();
  const auto entry = findEntry(registry.environments, "environment", "pendulum");
  ASSERT_TRUE(entry);
  const auto compiled = (*entry)->make();
  Robot file(robotOf(robotText("pendulum")));
  const std::vector<double> start{0.4, 0.0, 0.0};
  ASSERT_TRUE(compiled->place(start));
  ASSERT_TRUE(file.place(start));
  const double before = signalsNow(*compiled)["energy"] - signalsNow(file)["mechanical_energy"];
  for (int step = 0; step < 30; ++step) {
    const Action action = step % 3;
    static_cast<void>(compiled->step(action));
    static_cast<void>(file.step(action));
    auto a = signalsNow(*compiled), b = signalsNow(file);
    EXPECT_NEAR(a["cart_position"], b["base_x"], 1e-6) << step;
    EXPECT_NEAR(a["torque"], b["wheel_level"], 1e-12) << step;
    EXPECT_NEAR(a["energy"] - b["mechanical_energy"], before, 1e-5) << step;
    EXPECT_NEAR(std::remainder(b["hinge_angle"] + file.state()[0], 2 * 3.14159265358979), 0.0, 1e-5) << step;
  }
}

TEST(RobotSignals, OfABipedTellJointsMotorsAndFeet) {
  Robot biped(robotOf(robotText("biped")));
  Random random(1);
  biped.reset(random);
  bool left = false, right = false;
  for (int step = 0; step < 60; ++step) {
    if (biped.step(step % 5).ending != Ending::None) biped.reset(random);
    auto now = signalsNow(biped);
    for (const auto& [key, value] : now) EXPECT_TRUE(std::isfinite(value)) << key << " in step " << step;
    EXPECT_NEAR(now["hip_left_power"], now["hip_left_effort"] * now["hip_l_rate"], 1e-9);
    left |= now["shin_l"] == 1.0, right |= now["shin_r"] == 1.0;
  }
  EXPECT_TRUE(left);
  EXPECT_TRUE(right);
}

TEST(RobotSignals, EveryRobotOfTheProgramHasThem) {
  for (const char* name : {"acrobot", "ball-beam", "biped", "cart-pole", "compass", "hopper", "leo", "segway"}) {
    Robot robot(robotOf(robotText(name)));
    Random random(3);
    robot.reset(random);
    for (const auto& [key, value] : signalsNow(robot)) EXPECT_TRUE(std::isfinite(value)) << name << ": " << key;
  }
}

}  // namespace surefoot
