// SPDX-License-Identifier: GPL-3.0-or-later
// The chain of the thesis's Figure 4.2 and the grid of its Figure 6.1.
#include <gtest/gtest.h>

#include "core/agents/td_control.h"
#include "core/environments/chain.h"
#include "core/environments/grid_world.h"
#include "core/features/tile_coder.h"
#include "core/policies/greedy.h"

namespace surefoot {

namespace {

using Learner = TdControl<SarsaTarget, TileCoder>;

/// Sarsa with step size 1 and weights from 0.
Learner learnerFor(const Task& task, int tilings, double scale) {
  TileSettings tiles(task);
  tiles.tilings = tilings;
  tiles.scale = scale;
  return Learner(Estimate<TileCoder>(LinearActionValue<TileCoder>(*TileCoder::create(task, tiles),
                                                                  static_cast<int>(task.actions.size()), {0.0, 0.0}, 1),
                                     EstimateSettings{1.0, 0.0}),
                 ControlSettings{0.98, {}});
}

double q(const Learner& learner, std::vector<double> state, Action action) {
  std::vector<double> values(static_cast<std::size_t>(learner.values().actions()));
  learner.values().evaluate(state, Layer::Sum, values);
  return values[static_cast<std::size_t>(action)];
}

}  // namespace

// After one update of state 5 by 100 the states 3 … 7 are worth 1/3, 2/3, 1, 2/3, 1/3 of it.
TEST(Chain, OneUpdateSpreadsAsInFigure42) {
  Chain chain;
  Learner learner = learnerFor(chain.task(), 3, 1.0);
  Greedy policy;
  learner.setPolicy(policy);
  Random random(1);
  const Action action = learner.start(std::vector<double>{5}, random);
  learner.end({.reward = 100, .ending = Ending::Terminal});
  const double expected[] = {0, 0, 100.0 / 3, 200.0 / 3, 100, 200.0 / 3, 100.0 / 3, 0, 0, 0};
  for (int s = 1; s <= 10; ++s) EXPECT_NEAR(q(learner, {s + 0.0}, action), expected[s - 1], 1e-12) << "state " << s;
}

TEST(Chain, EndsInAFallOnTheLeftAndAtTheGoalOnTheRight) {
  Chain chain;
  Random random(2);
  for (const auto& [action, event, reward] :
       {std::tuple{0, Event::Fall, -100.0}, std::tuple{1, Event::Success, 100.0}}) {
    chain.reset(random);
    Outcome outcome;
    while (outcome.ending == Ending::None) outcome = chain.step(action);
    EXPECT_EQ(outcome.event, event);
    EXPECT_EQ(outcome.reward, reward);
  }
}

// Figure 6.1: the same experience, once into the bad region from the left in row 4, with coarse and with fine tiles.
// Then one stands in row 5, where one has not been: the coarse function warns of the step to the right.
TEST(GridWorld, TheCoarseFunctionWarnsAndTheFineOneDoesNot) {
  GridWorld world;
  Random random(1);
  Greedy policy;
  double value[2];
  const double scales[2] = {1.0 / 3, 1.0};
  for (int i = 0; i < 2; ++i) {
    Learner learner = learnerFor(world.task(), 1, scales[i]);
    learner.setPolicy(policy);
    world.resetTo(GridWorld::kBadLeft - 1, 4);
    // The learner is led: with all values equal the policy may choose any action, so choose until it is the right one.
    Action action = kNoAction;
    while (action != Grid::Right) action = learner.start(world.state(), random);
    const Outcome fall = world.step(action);
    ASSERT_EQ(fall.event, Event::Fall);
    learner.end(fall);
    value[i] = q(learner, {GridWorld::kBadLeft - 1.0, 5.0}, Grid::Right);
  }
  EXPECT_EQ(value[0], -100.0) << "coarse: one tile of 3 × 3 cells";
  EXPECT_EQ(value[1], 0.0) << "fine: still at its start value";
}

TEST(GridWorld, LeadsAroundTheBadRegionToTheGoal) {
  GridWorld world;
  Random random(1);
  world.reset(random);
  Outcome outcome;
  for (int i = 0; i < 9; ++i) outcome = world.step(Grid::Up);
  for (int i = 0; i < 9 && outcome.ending == Ending::None; ++i) outcome = world.step(Grid::Right);
  EXPECT_EQ(outcome.event, Event::Success);
  EXPECT_EQ(outcome.reward, 100);
}

}  // namespace surefoot
