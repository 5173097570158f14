// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environments/mountain_car.h"
#include "core/register/register.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/experiment/configuration.h"

namespace surefoot {

namespace {

/// Mean steps of every episode over 30 lives: greedy, γ = 1, weights from 0, 8 tilings of 8 × 8, total α .5
/// (Figure 10.2).
std::vector<double> stepsPerEpisode(const std::string& traceDecay, int episodes) {
  Registry r;
  registerCore(r);
  Names names;
  names.environment = "mountain-car", names.policy = "greedy";
  auto c = configure(r, names,
                     {{"agent.step_size", "0.5"},
                      {"agent.discount", "1"},
                      {"agent.trace_decay", traceDecay},
                      {"features.tilings", "8"},
                      {"features.initial_high", "0"}});
  EXPECT_TRUE(c) << c.error().message;
  c->episodes = episodes;
  constexpr int kLives = 30;
  std::vector<double> mean(static_cast<std::size_t>(episodes), 0.0);
  for (int index = 0; index < kLives; ++index) {
    auto life = makeLife(r, *c, index, true);
    while (!(*life)->finished()) (*life)->step();
    for (std::size_t i = 0; i < mean.size(); ++i)
      mean[i] += static_cast<double>((*life)->log().rows()[i].steps) / kLives;
  }
  return mean;
}

}  // namespace

// One step by hand: x = −0.5, ẋ = 0.01, forward: ẋ = 0.01 + 0.001 − 0.0025·cos(−1.5).
TEST(MountainCar, FollowsItsEquation) {
  MountainCar car;
  car.resetTo(-0.5, 0.01);
  EXPECT_EQ(car.step(2).reward, -1);
  const double v = 0.01 + 0.001 - 0.0025 * std::cos(-1.5);
  EXPECT_NEAR(car.state()[1], v, 1e-15);
  EXPECT_NEAR(car.state()[0], -0.5 + v, 1e-15);
}

TEST(MountainCar, StopsAtTheLeftAndEndsAtTheRight) {
  MountainCar car;
  car.resetTo(-1.19, -0.07);
  EXPECT_EQ(car.step(0).ending, Ending::None);
  EXPECT_EQ(car.state()[0], -1.2);
  EXPECT_EQ(car.state()[1], 0.0);
  car.resetTo(0.48, 0.07);
  EXPECT_EQ(car.step(2).ending, Ending::Terminal);
}

// Sutton & Barto 2018, Figure 10.2 (α = 0.5/8): about 120 steps an episode at episode 500. The figure has a logarithmic
// scale from 100 to 1000 and is read to about ± 15; the mean of the last 50 episodes stands for the 500th.
TEST(MountainCar, IsLearnedAsInFigure102) {
  const auto steps = stepsPerEpisode("0", 500);
  double late = 0.0;
  for (std::size_t i = 450; i < 500; ++i) late += steps[i] / 50;
  EXPECT_NEAR(late, 120, 15);
  EXPECT_GT(steps[0], 300) << "the first episode is long";
}

// Figure 12.10: traces learn faster early.
TEST(MountainCar, TracesLearnFasterEarly) {
  const auto sum = [](const std::vector<double>& steps) {
    double total = 0.0;
    for (const double s : steps) total += s;
    return total;
  };
  EXPECT_LT(sum(stepsPerEpisode("0.9", 50)), sum(stepsPerEpisode("0", 50)));
}

}  // namespace surefoot
