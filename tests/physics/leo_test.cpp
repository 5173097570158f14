// SPDX-License-Identifier: GPL-3.0-or-later
// LEO against its own mechanics and the laboratory's hand-made controller.
#include "physics/leo/leo.h"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot {

using namespace leo;

namespace {

struct Walk {
  bool fell = false;
  double seconds = 0, distance = 0, reward = 0, separation = 0;
};

Walk handMadeWalk(double target) {
  LeoSettings settings;
  settings.hipTarget = target;
  Leo walker(settings);
  Random random(1);
  walker.reset(random);
  Walk walk;
  const double start = walker.world().hip().x;
  for (Outcome o; o.ending == Ending::None;) {
    o = walker.step(kHandMade);
    walk.seconds += LeoWorld::kStepTime;
    walk.reward += o.reward;
    walk.separation = std::max(walk.separation, walker.world().jointSeparation());
    walk.fell = o.event == Event::Fall;
  }
  walk.distance = walker.world().hip().x - start;
  return walk;
}

}  // namespace

TEST(Leo, TheHandMadeControllerWalks) {
  int walks = 0;
  for (int i = 0; i < 10; ++i) {
    const Walk walk = handMadeWalk(0.67 + 0.0026 * i);
    std::printf("hip target %.4f: %s after %.1f s, %.2f m, return %.0f, joints %.3f mm apart\n", 0.67 + 0.0026 * i,
                walk.fell ? "fell" : "walked", walk.seconds, walk.distance, walk.reward, 1e3 * walk.separation);
    walks += !walk.fell;
    EXPECT_LT(walk.separation, 1e-4);
    if (walk.fell) continue;
    EXPECT_GT(walk.distance, 7.5);
    EXPECT_GT(walk.reward, 3000);
  }
  EXPECT_GE(walks, 8);
}

TEST(Leo, StandsWithTheLowestCircleOnTheFloor) {
  const LeoWorld world({}, Anatomy().start, {});
  EXPECT_LT(world.jointSeparation(), 1e-6);
  // The left leg is upright: sole to ankle, ankle to knee, knee to hip.
  const double height = (0.0035 + 0.0095 + 0.03559) + (0.05225 + 0.05225) + (0.058 + 0.058);
  EXPECT_NEAR(world.hip().y, height, 1e-5);
  EXPECT_NEAR(world.jointAngle(kRightHip), 0.82, 1e-6);
  EXPECT_NEAR(world.jointAngle(kRightKnee), -1.27, 1e-6);
}

// No load and no friction: the back-EMF holds the motor at ω = U/(k·G) = 5.58 rad/s. The thigh's weight and the turning
// of the torso take from that and add to it.
TEST(Leo, AMotorReachesItsSpeedWithoutLoad) {
  LeoSettings settings;
  settings.dryFriction = 0.0;
  settings.anatomy.torso = {9.0, 0.065869, settings.anatomy.torso.centre};  // so that the thigh turns and not the torso
  LeoWorld world(settings, Anatomy().start, {});
  LeoWorld::Voltages u{};
  u[kRightHip] = settings.voltage;
  double fastest = 0;
  for (int i = 0; i < 8; ++i) {
    world.step(u);
    fastest = std::max(fastest, world.jointRate(kRightHip));
  }
  const double kG = settings.torqueConstant * settings.gearRatio;
  EXPECT_NEAR(settings.voltage / kG, 5.58, 0.01);
  EXPECT_LT(fastest, 6.5);
  EXPECT_GT(fastest, 4.0);
}

TEST(Leo, LimitsHoldTheKnees) {
  const JointKind knee = Anatomy().knee;
  LeoWorld world({}, Anatomy().start, {});
  LeoWorld::Voltages u{};
  u[kRightKnee] = 10.69;
  double most = 0.0;
  for (int i = 0; i < 15; ++i) {  // the robot is still in the air between its feet
    world.step(u);
    most = std::max(most, world.jointAngle(kRightKnee));
  }
  EXPECT_LT(most, knee.high + 1.785 / 50.0 + 0.01) << "the stop yields by the motor's torque over its stiffness";
  EXPECT_GT(most, knee.high);
}

TEST(Leo, StateIsSeenFromTheLegThatStands) {
  Leo walker;
  Random random(1);
  walker.reset(random);
  EXPECT_EQ(walker.stanceLeg(), 0);
  EXPECT_NEAR(walker.state()[0], -0.10, 1e-6);
  EXPECT_NEAR(walker.state()[2], 0.10, 1e-6);
  EXPECT_NEAR(walker.state()[4], 0.82, 1e-6);
  int changes = 0, before = 0;
  for (int i = 0; i < 120; ++i) {
    walker.step(kHandMade);
    if (walker.stanceLeg() != before) ++changes;
    before = walker.stanceLeg();
    // The swing hip is that of the other leg.
    const LeoWorld& w = walker.world();
    EXPECT_EQ(walker.state()[4], w.jointAngle(static_cast<Joint>(kLeftHip + 1 - walker.stanceLeg())));
  }
  EXPECT_GE(changes, 3);
}

TEST(Leo, ActionsAreCombinationsOfLevels) {
  const Leo walker;
  const Task& task = walker.task();
  ASSERT_EQ(task.actions.size(), 343u);
  ASSERT_EQ(task.actionVariables.size(), 3u);
  EXPECT_NEAR(task.actionVariables[0].levels.front(), -10.69, 1e-12);
  EXPECT_EQ(task.actionVariables[1].levels[3], 0.0);
  EXPECT_EQ(task.rewardTerms.size(), 4u);
}

TEST(Leo, RewardIsTheSumOfItsTermsAndAFallIsDoom) {
  Leo walker;
  Random random(1);
  walker.reset(random);
  Outcome o;
  double distance = 0;
  while (o.ending == Ending::None) {
    o = walker.step(0);
    EXPECT_NEAR(o.reward, o.terms[0] + o.terms[1] + o.terms[2] + o.terms[3], 1e-12);
    EXPECT_LE(o.terms[1], 0.0);
    distance += o.terms[2] / 300;
  }
  EXPECT_EQ(o.event, Event::Fall);
  EXPECT_EQ(o.terms[3], -125.0);
  EXPECT_TRUE(std::abs(walker.state()[0]) > 1.0 || std::abs(walker.state()[0] + walker.state()[2]) > 0.36 * M_PI);
}

// Also of the step that ends in a footstep: what the leg swung before it touched the floor counts.
TEST(Leo, TheFootstepTermIsHowFarTheLegsPartInTheRolesTheyHadBefore) {
  Leo walker;
  Random random(1);
  walker.reset(random);
  const auto ankles = [&](int stance) { return walker.world().ankle(1 - stance).x - walker.world().ankle(stance).x; };
  int footsteps = 0;
  double swung = 0.0;
  for (int i = 0; i < 750; ++i) {
    const int stance = walker.stanceLeg();
    const double before = ankles(stance);
    const Outcome o = walker.step(kHandMade);
    ASSERT_NE(o.event, Event::Fall);
    EXPECT_NEAR(o.terms[2], 300 * (ankles(stance) - before), 1e-9);
    if (walker.stanceLeg() == stance) continue;
    ++footsteps;
    swung += ankles(stance);
  }
  EXPECT_GT(footsteps, 40);
  std::printf("%d footsteps of %.3f m on the mean, %.2f m together\n", footsteps, swung / footsteps, swung);
  // The laboratory adds up its footsteps and comes to 7.5 … 9 m; the hip gets further, because feet roll.
  EXPECT_GT(swung, 7.5);
  EXPECT_LT(swung, 9.0);
}

// U·I of hips and knees, I = (U − k·G·ω)/R, ω the mean of before and after.
TEST(Leo, EnergyIsWhatTheMotorsTake) {
  Leo walker;
  Random random(1);
  walker.reset(random);
  const LeoSettings s;
  const double kG = s.torqueConstant * s.gearRatio;
  const auto rates = [&] {
    std::array<double, 4> r{};
    for (std::size_t j = 0; j < 4; ++j) r[j] = walker.world().jointRate(static_cast<Joint>(j));
    return r;
  };
  const double stanceKnee = walker.state()[6];
  const auto before = rates();
  const Outcome o = walker.step(0);  // all three voltages lowest; the left leg stands
  const auto after = rates();
  const std::array<double, 4> volts = {-10.69, -10.69, std::clamp(-21.21 * stanceKnee, -10.69, 10.69), -10.69};
  double joules = 0.0;
  for (std::size_t j = 0; j < 4; ++j)
    joules += std::max(0.0, volts[j] * (volts[j] - kG * (before[j] + after[j]) / 2) / s.resistance) / 30;
  EXPECT_NEAR(o.terms[1], -3 * joules, 1e-9);
  EXPECT_GT(joules, 0.1);
}

TEST(Leo, AnEpisodeRepeatsBitForBit) {
  const auto run = [] {
    Leo walker;
    Random random(1), choice(7);
    walker.reset(random);
    double sum = 0;
    for (int i = 0; i < 60; ++i) {
      const Outcome o = walker.step(static_cast<Action>(choice.uniform(0, 343)));
      sum = 1.1 * sum + o.reward + walker.state()[5];
      if (o.ending != Ending::None) walker.reset(random);
    }
    return sum;
  };
  EXPECT_EQ(run(), run());
}

}  // namespace surefoot
