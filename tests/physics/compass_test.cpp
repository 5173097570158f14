// SPDX-License-Identifier: GPL-3.0-or-later
// The compass walker against mechanics: what is known of walkers without a motor.
#include "physics/compass/compass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace surefoot {

namespace {

/// Footsteps that a walker without torque makes in a time, until it falls; their lengths.
std::vector<double> passiveWalk(double slope, CompassWorld::Posture start, double seconds) {
  CompassSettings settings;
  settings.slope = slope;
  CompassWorld world(settings, start);
  std::vector<double> lengths;
  for (int i = 0; i < seconds / CompassWorld::kStepTime; ++i) {
    if (const double length = world.step(0.0); length != 0.0) lengths.push_back(length);
    if (std::abs(world.posture().stance) > 0.5) break;
  }
  return lengths;
}

}  // namespace

// Nothing turns the walker about the point where it strikes but gravity, and that has a millisecond (McGeer 1990,
// Passive dynamic walking, Int. J. Robotics Research 9(2)).
TEST(Compass, AngularMomentumAboutTheNewContactIsKeptAtHeelStrike) {
  constexpr double kMass = 2.0, kCentre = 0.1125, kSubstep = 0.001;
  CompassWorld world({}, {0.20, -1.4, -0.20, 0.0});
  int strikes = 0;
  for (int i = 0; i < 3000 && strikes < 3; ++i) {
    const double foot = world.footX(1 - world.stanceLeg());
    const double before = world.angularMomentum(foot);
    const CompassWorld::Posture p = world.posture();
    const double centre = world.hipX() + kCentre * (std::sin(p.stance) + std::sin(p.swing)) / 2 - foot;
    if (world.substep(p.swing - p.stance < 0.35 ? 0.6 : -0.3) == 0.0) continue;
    ++strikes;
    const double gravity = -kMass * 9.81 * centre * kSubstep;
    EXPECT_NEAR(world.angularMomentum(foot), before + gravity, 0.01 * std::abs(before)) << "strike " << strikes;
  }
  EXPECT_GE(strikes, 1);
}

// Walkers without a motor walk down gentle slopes for ever (McGeer; Goswami et al. 1998), in steps of one length, which
// grow with the slope.
TEST(Compass, WalksDownASlopeWithoutATorque) {
  double last = 0.0;
  for (const double slope : {0.01, 0.02, 0.03, 0.05}) {
    // From a start near the gait: tried are a few, because the basin of attraction is small.
    std::vector<double> best;
    for (double angle = 0.12; angle < 0.40; angle += 0.02)
      for (double rate = -0.9; rate > -2.3; rate -= 0.1) {
        const auto lengths = passiveWalk(slope, {angle, rate, -angle, 0.0}, 30.0);
        if (lengths.size() > best.size()) best = lengths;
      }
    ASSERT_GE(best.size(), 30u) << "slope " << slope;
    const std::vector<double> late(best.end() - 10, best.end());
    const double mean = std::accumulate(late.begin(), late.end(), 0.0) / 10;
    EXPECT_GT(mean, last) << "slope " << slope;
    last = mean;
  }
}

TEST(Compass, FallsOnALevelFloorWithoutATorque) {
  EXPECT_LT(passiveWalk(0.0, {0.20, -1.4, -0.20, 0.0}, 30.0).size(), 20u);
}

TEST(Compass, RewardsAreThoseOfItsTerms) {
  Compass compass;
  compass.place(std::vector<double>{0.20, -1.4, -0.20, 0.0});
  double footsteps = 0.0;
  Outcome o;
  for (int i = 0; i < 60 && o.ending == Ending::None; ++i) {
    o = compass.step(compass.state()[2] - compass.state()[0] < 0.35 ? 2 : 0);
    EXPECT_DOUBLE_EQ(o.reward, o.terms[0] + o.terms[1] + o.terms[2]);
    EXPECT_EQ(o.terms[2], -1.0);
    footsteps += o.terms[0] / 200.0;
  }
  EXPECT_EQ(o.event, Event::Fall) << "without going on it falls";
  EXPECT_EQ(o.terms[1], -100.0);
  EXPECT_GT(footsteps, 0.1) << "one good footstep at least";
}

TEST(Compass, AStandsWhereItIsPlaced) {
  Compass compass;
  const std::vector<double> state = {0.1, -1.0, -0.15, 0.5};
  ASSERT_TRUE(compass.place(state));
  for (std::size_t d = 0; d < 4; ++d) EXPECT_NEAR(compass.state()[d], state[d], 1e-6);
  EXPECT_NEAR(compass.world().hipY(), 0.43 * std::cos(0.1) + 0.02, 1e-6);
  const double x = compass.world().hipX();
  compass.push(1.0);
  compass.step(1);
  Compass other;
  other.place(state);
  other.step(1);
  EXPECT_GT(compass.world().hipX() - x, other.world().hipX() - x) << "a push to the right";
}

TEST(Compass, StartsVaryByTheNoise) {
  Compass compass;
  Random random(3);
  double least = 1, most = 0;
  for (int i = 0; i < 200; ++i) {
    compass.reset(random);
    least = std::min(least, compass.state()[0]), most = std::max(most, compass.state()[0]);
  }
  EXPECT_NEAR(least, 0.17, 0.003);
  EXPECT_NEAR(most, 0.23, 0.003);
}

}  // namespace surefoot
