// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/pendulum/pendulum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/registry.h"
#include "physics/register.h"

namespace surefoot {

constexpr double kPi = std::numbers::pi;

TEST(Pendulum, HasTheThesissActionsRewardsAndStepTime) {
  Pendulum p;
  EXPECT_EQ(p.task().actions, (std::vector<double>{-1.5, -0.75, 0.0, 0.75, 1.5}));
  EXPECT_EQ(p.task().rewardTerms, (std::vector<std::string>{"goal", "fall", "time"}));
  EXPECT_EQ(p.task().stepTime, 0.005);
}

TEST(Pendulum, FallsAtTheFallAngle) {
  Pendulum p;
  p.resetTo(0.449 * kPi, 5.0, 0);
  const Outcome o = p.step(2);
  EXPECT_EQ(o.ending, Ending::Terminal);
  EXPECT_EQ(o.event, Event::Fall);
  EXPECT_EQ(o.reward, -100.0);
  EXPECT_EQ(o.terms[1], -100.0);
}

TEST(Pendulum, IsBalancedNearUprightAtRest) {
  Pendulum p;
  p.resetTo(0.001, 0, 0);
  const Outcome o = p.step(2);
  EXPECT_EQ(o.ending, Ending::Terminal);
  EXPECT_EQ(o.event, Event::Success);
  EXPECT_EQ(o.reward, 200.0);
}

TEST(Pendulum, IsNotBalancedWhileItMoves) {
  Pendulum p;
  p.resetTo(0.0, 0.1, 0);
  EXPECT_EQ(p.step(2).ending, Ending::None);
}

TEST(Pendulum, TheStepLimitTruncates) {
  PendulumSettings s;
  s.maxSteps = 3;
  s.timeReward = -1;
  Pendulum p(s);
  p.resetTo(0.2, 0, 0);
  EXPECT_EQ(p.step(2).ending, Ending::None);
  EXPECT_EQ(p.step(2).ending, Ending::None);
  const Outcome o = p.step(2);
  EXPECT_EQ(o.ending, Ending::Truncated);
  EXPECT_EQ(o.event, Event::None);
  EXPECT_EQ(o.reward, -1.0);
}

TEST(Pendulum, StartsAtRestWithinTheStartRange) {
  Pendulum p;
  Random random(1);
  double largest = 0;
  for (int i = 0; i < 2000; ++i) {
    p.reset(random);
    largest = std::max(largest, std::abs(p.state()[0]));
    ASSERT_EQ(p.state()[1], 0.0);
    ASSERT_EQ(p.state()[2], 0.0);
    ASSERT_EQ(p.pose()[0], 0.0);
  }
  EXPECT_LE(largest, 15.0 / 180 * kPi + 1e-6);
  EXPECT_GT(largest, 14.5 / 180 * kPi);
}

// Nothing of an episode survives into the next: not even the impulses that Box2D keeps in its joints.
TEST(Pendulum, AResetLeavesNothingBehind) {
  for (const double friction : {0.0, 0.05}) {
    PendulumSettings s;
    s.friction = friction;
    Pendulum fresh(s), used(s);
    used.resetTo(0.2, 1.0, -3.0);
    for (int i = 0; i < 57; ++i) used.advance(i % 3 - 1.0);
    fresh.resetTo(-0.1, 0, 0);
    used.resetTo(-0.1, 0, 0);
    for (int i = 0; i < 100; ++i) {
      fresh.advance(0.75);
      used.advance(0.75);
      ASSERT_EQ(std::vector<double>(fresh.state().begin(), fresh.state().end()),
                std::vector<double>(used.state().begin(), used.state().end()))
          << "step " << i;
    }
  }
}

TEST(Pendulum, APositiveTorqueDrivesTheCartRightAndTheUprightPoleLeft) {
  Pendulum p;
  p.resetTo(0, 0, 0);
  for (int i = 0; i < 10; ++i) p.advance(1.0);
  EXPECT_GT(p.pose()[0], 0.0);
  EXPECT_GT(p.state()[2], 0.0);
  EXPECT_LT(p.state()[0], 0.0);
}

// Table 4.1, and the ratios that the text draws from it (claim A6: 10 %, 2 %, 1.3 %, 3.3 %, 50 %).
TEST(Scenarios, AreThoseOfTable41) {
  Registry registry;
  registerPhysics(registry);
  const double expected[7][3] = {{0.08, 0, 1},   {0.088, 0.03, 1}, {0.04, 0.02, 1},   {0.01, 0.05, 1},
                                 {0.08, 0, 2.5}, {0.08, 0, 0.5},   {0.088, 0.03, 2.5}};
  const char* names[] = {"actual", "1", "2", "3", "4", "5", "6"};
  ASSERT_EQ(registry.scenarios.size(), 7u);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(registry.scenarios[i].name, names[i]);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(registry.scenarios[i].values[k].second, expected[i][k]);
  }
  const auto value = [&](std::size_t scenario, std::size_t k) { return registry.scenarios[scenario].values[k].second; };
  const double torque = 1.5;
  EXPECT_NEAR(value(1, 0) / value(0, 0) - 1, 0.10, 1e-12);
  EXPECT_NEAR(value(1, 1) / torque, 0.02, 1e-12);
  EXPECT_NEAR(value(2, 1) / torque, 0.013, 5e-4);
  EXPECT_NEAR(value(3, 1) / torque, 0.033, 5e-4);
  EXPECT_NEAR(1 - value(2, 0) / value(0, 0), 0.50, 1e-12);
}

TEST(Pendulum, AnglesThatDoNotGoTogetherAreNamed) {
  PendulumSettings s;
  EXPECT_TRUE(Pendulum(s).check());
  s.startAngle = 1.5;
  const Status status = Pendulum(s).check();
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().message.find("environment.start_angle"), std::string::npos);
}

TEST(Pendulum, DrawsAPoleWhereTheStateSays) {
  Pendulum p;
  p.resetTo(0.3, 0, 0);
  Scene scene;
  p.draw(p.pose(), scene);
  EXPECT_NEAR(scene.tip.x, 0.1 * std::sin(0.3), 1e-6);
  EXPECT_GT(scene.shapes.size(), 10u);
}

}  // namespace surefoot
