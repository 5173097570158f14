// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environments/cliff.h"
#include "core/register/register.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/experiment/configuration.h"

namespace surefoot {

namespace {

enum Move { kUp, kDown, kLeft, kRight };

/// 100 lives of 500 episodes with the settings of example 6.6: the mean online reward an episode over the last 400
/// episodes, and the highest row that the greedy path of the first life visits.
struct Result66 {
  double online = 0;
  double highestRow = 0;
};

Result66 example66(const std::string& agent) {
  Registry r;
  registerCore(r);
  Names names;
  names.environment = "cliff", names.agent = agent, names.features = "table", names.policy = "epsilon-greedy";
  auto c = configure(r, names,
                     {{"policy.epsilon", "0.1"},
                      {"agent.step_size", "0.5"},
                      {"agent.discount", "1"},
                      {"agent.trace_decay", "0"},
                      {"features.initial_high", "0"}});
  EXPECT_TRUE(c) << c.error().message;
  c->episodes = 500;
  Result66 result;
  constexpr int kLives = 100;
  for (int index = 0; index < kLives; ++index) {
    auto life = makeLife(r, *c, index, true);
    EXPECT_TRUE(life) << life.error().message;
    while (!(*life)->finished()) (*life)->step();
    const auto& rows = (*life)->log().rows();
    for (std::size_t i = 100; i < rows.size(); ++i) result.online += rows[i].reward / 400 / kLives;
    if (index > 0) continue;
    Cliff cliff;
    Random unused(1);
    cliff.reset(unused);
    std::vector<double> q(4);
    for (int step = 0; step < 60; ++step) {
      (*life)->agent().values().evaluate(cliff.state(), Layer::Sum, q);
      const auto best = static_cast<Action>(std::max_element(q.begin(), q.end()) - q.begin());
      if (cliff.step(best).ending != Ending::None) break;
      result.highestRow = std::max(result.highestRow, cliff.state()[1]);
    }
  }
  return result;
}

}  // namespace

TEST(Cliff, AStepIntoTheCliffCostsAHundredAndLeadsBackToTheStart) {
  Cliff cliff;
  Random random(1);
  cliff.reset(random);
  const Outcome o = cliff.step(kRight);
  EXPECT_EQ(o.reward, -100);
  EXPECT_EQ(o.event, Event::Fall);
  EXPECT_EQ(o.ending, Ending::None);
  EXPECT_EQ(cliff.state()[0], 0);
  EXPECT_EQ(cliff.state()[1], 0);
}

// Up, eleven times right, down: 13 steps of −1 along the edge.
TEST(Cliff, TheShortestPathIsThirteenSteps) {
  Cliff cliff;
  Random random(1);
  cliff.reset(random);
  double total = cliff.step(kUp).reward;
  for (int i = 0; i < 11; ++i) total += cliff.step(kRight).reward;
  const Outcome last = cliff.step(kDown);
  EXPECT_EQ(total + last.reward, -13);
  EXPECT_EQ(last.ending, Ending::Terminal);
  EXPECT_EQ(last.event, Event::Success);
}

TEST(Cliff, WallsHold) {
  Cliff cliff;
  Random random(1);
  cliff.reset(random);
  EXPECT_EQ(cliff.step(kLeft).reward, -1);
  EXPECT_EQ(cliff.state()[0], 0);
}

// Sutton & Barto 2018, example 6.6 and its figure: online reward about −25 for Sarsa and −50 for Q-learning;
// Q-learning's greedy path runs along the edge (row 1), Sarsa's takes the upper rows. The figure is read to ± 5.
TEST(Cliff, IsLearnedAsInExample66) {
  const Result66 sarsa = example66("sarsa"), q = example66("q-learning"), expected = example66("expected-sarsa");
  EXPECT_NEAR(sarsa.online, -25, 5);
  EXPECT_NEAR(q.online, -50, 7);
  EXPECT_GE(expected.online, sarsa.online - 1);
  EXPECT_EQ(q.highestRow, 1) << "along the edge";
  EXPECT_GE(sarsa.highestRow, 2) << "the safe path";
  RecordProperty("sarsa", std::to_string(sarsa.online));
}

}  // namespace surefoot
