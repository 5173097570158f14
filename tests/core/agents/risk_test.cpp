// SPDX-License-Identifier: GPL-3.0-or-later
// The risk of a fall beside any agent: what it may not change, and what it must be equal to.
#include "core/agents/risk.h"

#include <gtest/gtest.h>

#include "core/agents/td_control.h"
#include "core/experiment/configuration_json.h"
#include "core/policies/greedy.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

std::unique_ptr<Life> lifeWith(const Registry& registry, const std::string& agent,
                               const std::vector<Assignment>& assignments, const std::string& environment = "pendulum",
                               const std::string& features = "tile-coder") {
  auto c = configure(registry, {.environment = environment, .agent = agent, .features = features}, assignments);
  EXPECT_TRUE(c) << (c ? "" : c.error().message);
  c->episodes = 200;
  auto life = makeLife(registry, *c, 0, true);
  EXPECT_TRUE(life) << (life ? "" : life.error().message);
  while (!(*life)->finished()) (*life)->step();
  return std::move(*life);
}

/// How two lives went, up to rounding: every episode's length and falls.
void expectTheSame(const Life& one, const Life& other) {
  ASSERT_EQ(one.log().rows().size(), other.log().rows().size());
  for (std::size_t i = 0; i < one.log().rows().size(); ++i) {
    EXPECT_EQ(one.log().rows()[i].steps, other.log().rows()[i].steps) << "episode " << i;
    EXPECT_EQ(one.log().rows()[i].falls, other.log().rows()[i].falls);
  }
}

}  // namespace

TEST(Risk, LearnedAndNotObeyedItChangesNoBit) {
  const Registry registry = fullRegistry();
  for (const char* agent : {"sarsa", "q-learning", "expected-sarsa", "sarsa-2q"}) {
    const auto without = lifeWith(registry, agent, {}), with = lifeWith(registry, agent, {{"risk.learn", "on"}});
    EXPECT_EQ(with->hash(), without->hash()) << agent;
    EXPECT_GT(with->log().totals().falls, 20);
  }
  const std::vector<Assignment> hashed = {{"features.memory", "65536"}, {"risk.memory", "65536"}};
  std::vector<Assignment> learned = hashed;
  learned.push_back({"risk.learn", "on"});
  EXPECT_EQ(lifeWith(registry, "sarsa", learned)->hash(), lifeWith(registry, "sarsa", hashed)->hash());
  EXPECT_EQ(lifeWith(registry, "sarsa", {{"risk.learn", "on"}}, "pendulum", "radial-basis")->hash(),
            lifeWith(registry, "sarsa", {}, "pendulum", "radial-basis")->hash());
}

// Sarsa is linear in the reward: acting on q̂ − w ρ, with ρ on q̂'s tiles and learned like it, is a fall reward that is
// lower by w. Much of what is called risk-sensitive is that.
TEST(Risk, AWeightOnEqualTilesIsALowerFallReward) {
  const Registry registry = fullRegistry();
  const auto weight = lifeWith(
      registry, "sarsa",
      {{"risk.learn", "on"}, {"risk.discount", "0.98"}, {"policy.risk", "weight"}, {"policy.risk_weight", "300"}});
  const auto lower = lifeWith(registry, "sarsa", {{"environment.fall_reward", "-400"}});
  expectTheSame(*weight, *lower);
}

// With coarser tiles it is Sarsa_2Q with the falls alone in Q⁻; where the weight is a power of two, bit for bit.
TEST(Risk, AWeightOnCoarserTilesIsSarsa2QWithTheFallsInQMinus) {
  const Registry registry = fullRegistry();
  const std::vector<Assignment> plain = {{"features.initial_high", "0"}, {"environment.time_reward", "0"}};
  std::vector<Assignment> risk = plain, parts = plain;
  for (const auto& [key, value] : {std::pair{"environment.fall_reward", "0"},
                                   {"risk.learn", "on"},
                                   {"risk.scale", "0.5"},
                                   {"risk.discount", "0.98"},
                                   {"policy.risk", "weight"},
                                   {"policy.risk_weight", "128"}})
    risk.push_back({key, value});
  for (const auto& [key, value] : {std::pair{"environment.fall_reward", "-128"}, {"negative.scale", "0.5"}})
    parts.push_back({key, value});
  expectTheSame(*lifeWith(registry, "sarsa", risk), *lifeWith(registry, "sarsa-2q", parts));
}

// Sarsa_2Q acts on Q⁺ + k Q⁻ with a live factor: k = 1 is the thesis's.
TEST(Risk, TheFactorOneOfLossesIsSarsa2Q) {
  const Registry registry = fullRegistry();
  const auto one = lifeWith(registry, "sarsa-2q", {{"policy.risk", "losses"}}),
             none = lifeWith(registry, "sarsa-2q", {});
  EXPECT_EQ(one->hash(), none->hash());
  const auto eight = lifeWith(registry, "sarsa-2q", {{"policy.risk", "losses"}, {"policy.losses_factor", "8"}});
  EXPECT_NE(eight->hash(), none->hash());
}

TEST(Risk, ARuleThatNeedsWhatIsNotLearnedIsRefused) {
  const Registry registry = fullRegistry();
  for (const auto& [agent, rule, words] : {std::tuple{"sarsa", "filter", "risk.learn = on"},
                                           {"sarsa-2q", "weight", "risk.learn = on"},
                                           {"sarsa", "losses", "sarsa-2q"}}) {
    auto c = configure(registry, {.environment = "pendulum", .agent = agent}, {{"policy.risk", rule}});
    ASSERT_TRUE(c) << c.error().message;
    const auto refused = makeLife(registry, *c, 0, false);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find(words), std::string::npos) << refused.error().message;
  }
  const auto life = lifeWith(registry, "sarsa", {});
  EXPECT_FALSE(life->set("policy.risk", 2.0));
  EXPECT_EQ(life->parameters().get("policy.risk"), 0);
  EXPECT_TRUE(life->changes().empty());
}

// Files and stores that do not use it stay as they were.
TEST(Risk, IsWrittenOnlyWhereItIsUsed) {
  const Registry registry = fullRegistry();
  const auto plain = configure(registry, {.environment = "pendulum", .agent = "sarsa"}, {});
  for (const auto& [key, value] : configurationAsJson(*plain)["parameters"].items())
    EXPECT_TRUE(!key.starts_with("risk.") && !key.starts_with("policy.risk") && !key.starts_with("policy.losses"));
  const std::vector<Assignment> used = {{"risk.learn", "on"}, {"risk.scale", "0.5"}, {"policy.risk", "filter"}};
  const auto with = configure(registry, {.environment = "pendulum", .agent = "sarsa"}, used);
  const auto again = configurationFromJson(registry, Json::parse(configurationAsJson(*with).dump()), "file");
  ASSERT_TRUE(again) << again.error().message;
  for (const auto& entry : with->parameters.all())
    EXPECT_EQ(again->parameters.get(entry.parameter.key), entry.value) << entry.parameter.key;
}

// On the cliff, walked at random.
TEST(Risk, IsTheProbabilityOfAFall) {
  const Registry registry = fullRegistry();
  auto c = configure(registry, {.environment = "cliff", .agent = "sarsa", .features = "table"},
                     {{"risk.learn", "on"}, {"risk.step_size", "0.02"}, {"policy.epsilon", "1"}});
  ASSERT_TRUE(c) << c.error().message;
  auto life = makeLife(registry, *c, 0, false);
  ASSERT_TRUE(life) << life.error().message;
  for (int i = 0; i < 400'000; ++i) (*life)->step();
  std::vector<double> risk(4);
  const auto at = [&](double column, double row) {
    (*life)->agent().values().evaluate(std::vector<double>{column, row}, Layer::Risk, risk);
    return risk;
  };
  // On the edge a step down falls for certain; in the corner beside the goal the step into it is safe.
  at(5, 1);
  EXPECT_NEAR(*std::max_element(risk.begin(), risk.end()), 1.0, 0.02);
  at(11, 1);
  EXPECT_NEAR(*std::min_element(risk.begin(), risk.end()), 0.0, 0.02);
  // At random nearly every walk falls before it comes to the goal.
  at(0, 3);
  for (const double r : risk) EXPECT_GT(r, 0.9);
}

}  // namespace surefoot
