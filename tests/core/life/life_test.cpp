// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/life.h"

#include <algorithm>

#include "tests/core/experiment/test_setup.h"

namespace surefoot {

TEST(Life, EndsAtTheEpisodeOrTheStepLimitWhicheverComesFirst) {
  const Registry r = fullRegistry();
  Configuration c = pendulumConfiguration(r);
  c.episodes = 7;
  c.minutes = 1000;
  auto life = lifeOf(r, c);
  while (!life->finished()) life->step();
  EXPECT_EQ(life->log().totals().episodes, 7);

  c.episodes = 1'000'000;
  c.minutes = 0.1;
  life = lifeOf(r, c);
  while (!life->finished()) life->step();
  EXPECT_EQ(life->steps(), 1200);  // 6 s of 5 ms
  EXPECT_DOUBLE_EQ(life->simulatedSeconds(), 6.0);
}

TEST(Life, AParameterOfTheWorldWaitsForTheNextEpisode) {
  const Registry r = fullRegistry();
  auto life = lifeOf(r, pendulumConfiguration(r));
  ASSERT_TRUE(life->set("environment.max_steps", 3));
  while (life->log().totals().episodes == 0) life->step();
  EXPECT_GT(life->log().last().steps, 3);
  while (life->log().totals().episodes == 1) life->step();
  EXPECT_LE(life->log().last().steps, 3);
}

// The goal of a task is known anew at the next episode, though a reward holds at once.
TEST(Life, AChangedRewardChangesWhatTheTaskSaysOfItself) {
  const Registry r = fullRegistry();
  auto life = lifeOf(r, pendulumConfiguration(r));
  ASSERT_TRUE(life->set("environment.goal_reward", 400));
  while (life->log().totals().episodes < 2) life->step();
  EXPECT_EQ(life->environment().task().highestReturn, 400);
}

TEST(Life, APolicyParameterHoldsAtOnce) {
  const Registry r = fullRegistry();
  auto life = lifeOf(r, pendulumConfiguration(r));
  ASSERT_TRUE(life->set("policy.epsilon", 1.0));
  std::vector<double> pi(5);
  life->policy().probabilities({.q = std::vector<double>{1, 2, 3, 4, 5}}, pi);
  EXPECT_DOUBLE_EQ(pi[0], 0.2);
  ASSERT_EQ(life->changes().size(), 1u);
  EXPECT_EQ(life->changes()[0].key, "policy.epsilon");
  EXPECT_EQ(life->changes()[0].before, "0.05");
}

TEST(Life, AParameterThatNeedsANewTableIsRefused) {
  const Registry r = fullRegistry();
  auto life = lifeOf(r, pendulumConfiguration(r));
  const Status s = life->set("features.tilings", 8);
  ASSERT_FALSE(s);
  EXPECT_NE(s.error().message.find("features.tilings"), std::string::npos);
}

TEST(Life, ANewPolicyTakesItsParametersFromTheLife) {
  const Registry r = fullRegistry();
  auto life = lifeOf(r, pendulumConfiguration(r));
  ASSERT_TRUE(life->set("policy.temperature", 1e6));
  life->setPolicy("softmax", *makePolicy(r, "softmax", life->parameters()));
  ASSERT_EQ(life->changes().size(), 2u);
  EXPECT_EQ(life->changes()[1].after, "softmax");
  std::vector<double> pi(2);
  life->policy().probabilities({.q = std::vector<double>{0, 10}}, pi);
  EXPECT_NEAR(pi[0], 0.5, 1e-4);
}

TEST(Life, DivergenceStopsItAndNamesTheParameter) {
  const Registry r = fullRegistry();
  Configuration c = pendulumConfiguration(
      r, "epsilon-greedy", {{"agent.step_size", "2"}, {"agent.trace", "accumulating"}, {"agent.discount", "1"}});
  c.episodes = 5000;
  auto life = lifeOf(r, c);
  while (!life->finished()) life->step();
  ASSERT_TRUE(life->diverged());
  EXPECT_NE(life->divergence().find("agent.trace"), std::string::npos) << life->divergence();
}

// Values from 10, step size 1, γ = .98: one step that the limit cuts off leaves R + .98·10, one that ends leaves R.
TEST(Life, AStepLimitIsNoEnd) {
  const Registry r = fullRegistry();
  Names names;
  names.environment = "cliff";
  names.features = "table";
  names.policy = "greedy";
  auto c = configure(r, names,
                     {{"environment.max_steps", "1"},
                      {"agent.step_size", "1"},
                      {"agent.discount", "0.98"},
                      {"features.initial_low", "10"},
                      {"features.initial_high", "10"}});
  ASSERT_TRUE(c) << c.error().message;
  auto life = lifeOf(r, *c);
  life->step();
  ASSERT_EQ(life->log().totals().episodes, 1);
  std::vector<double> q(4);
  life->agent().values().evaluate(std::vector<double>{0, 0}, Layer::Sum, q);
  const double learned = *std::min_element(q.begin(), q.end());
  EXPECT_NEAR(learned, life->log().last().reward + 9.8, 1e-12);
}

// An episode's inputs say of each action whether it was the best, as the agent counts it.
TEST(LifeInputs, SayWhichActionsExplored) {
  const Registry registry = fullRegistry();
  auto configuration = pendulumConfiguration(registry, "epsilon-greedy");
  ASSERT_TRUE(configuration.parameters.set("policy.epsilon", 0.3));
  configuration.episodes = 30;
  const auto life = makeLife(registry, configuration, 0, false);
  ASSERT_TRUE(life);
  (*life)->keepInputs();
  std::int64_t explored = 0, steps = 0;
  while (!(*life)->finished()) {
    (*life)->step();
    if ((*life)->inEpisode()) continue;
    const EpisodeInputs& inputs = (*life)->inputs();
    ASSERT_EQ(inputs.explored.size(), inputs.actions.size());
    for (const std::uint8_t one : inputs.explored) explored += one, ++steps;
  }
  EXPECT_EQ(steps, (*life)->steps());
  EXPECT_EQ(explored, (*life)->agent().explored());
  EXPECT_GT(explored, 0);
}

}  // namespace surefoot
