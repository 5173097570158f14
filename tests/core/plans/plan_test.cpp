// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plans/plan.h"

#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

Result<Plan> parse(const std::string& text, const PlanChanges& changes = {}) {
  static const Registry registry = fullRegistry();
  return parsePlan(registry, text, "folder/figure.toml", changes);
}

const std::string kPre = "[pre-learning]\nscenario = \"2\"\nuntil = 198\n";

void expectRefusal(const std::string& text, const std::vector<std::string>& words) {
  const auto plan = parse(text);
  ASSERT_FALSE(plan) << text;
  EXPECT_TRUE(plan.error().message.starts_with("figure.toml")) << plan.error().message;
  for (const std::string& word : words)
    EXPECT_NE(plan.error().message.find(word), std::string::npos) << plan.error().message;
}

}  // namespace

TEST(Plan, ListsMakeAGridTheLastVaryingFastest) {
  const auto plan = parse(
      "lives = 3\n[base]\nminutes = 1\nscenario = [\"2\", \"3\"]\n[[condition]]\nname = \"TRL {policy.threshold}\"\n"
      "policy = \"trl\"\nset.policy.threshold = [0, 50]\n");
  ASSERT_TRUE(plan) << plan.error().message;
  ASSERT_EQ(plan->conditions.size(), 4u);
  EXPECT_EQ(plan->conditions[0].name, "TRL 0, scenario 2");
  EXPECT_EQ(plan->conditions[1].name, "TRL 50, scenario 2");
  EXPECT_EQ(plan->conditions[3].name, "TRL 50, scenario 3");
  EXPECT_EQ(plan->conditions[3].configuration.parameters.get("policy.threshold"), 50);
  EXPECT_EQ(plan->conditions[3].configuration.names.scenario, "3");
  EXPECT_EQ(plan->lives, 3);
}

TEST(Plan, AConditionsSeedDependsOnWhatItIsAndNotOnItsPlaceOrLength) {
  const std::string one = "[[condition]]\nminutes = 1\npolicy = \"softmax\"\n";
  const std::string two = "[[condition]]\nminutes = 1\npolicy = \"greedy\"\n";
  const auto a = parse(one + two), b = parse(two + one);
  EXPECT_EQ(a->conditions[0].configuration.seed, b->conditions[1].configuration.seed);
  EXPECT_NE(a->conditions[0].configuration.seed, a->conditions[1].configuration.seed);
  const auto longer = parse("[[condition]]\nname = \"other\"\nminutes = 2\npolicy = \"softmax\"\n");
  EXPECT_EQ(longer->conditions[0].configuration.seed, a->conditions[0].configuration.seed);
  const auto other = parse(one, {.lives = {}, .seed = 2, .assignments = {}});
  EXPECT_NE(other->conditions[0].configuration.seed, a->conditions[0].configuration.seed);
  const auto paired = parse("paired = true\n" + one + two);
  EXPECT_EQ(paired->conditions[0].configuration.seed, paired->conditions[1].configuration.seed);
}

TEST(Plan, PlansOfDifferentSeriesShareNoLifeAndNoQFunction) {
  const auto of = [](const std::string& head) {
    const auto plan = parse(head + kPre + "[[condition]]\nminutes = 1\npolicy = \"softmax\"\n");
    EXPECT_TRUE(plan);
    return std::pair(plan->conditions[0].configuration.seed, plan->conditions[0].preLearning->configuration.seed);
  };
  for (const std::string paired : {"", "paired = true\n"}) {
    const auto none = of(paired), a = of(paired + "series = \"4.10\"\n"), b = of(paired + "series = \"4.11\"\n");
    EXPECT_NE(a.first, b.first);
    EXPECT_NE(a.second, b.second);
    EXPECT_NE(a.first, none.first);
    EXPECT_EQ(a, of(paired + "series = \"4.10\"\n"));
  }
}

TEST(Plan, PreLearningTakesEverythingButPolicyAndStepSize) {
  const auto plan = parse(kPre +
                          "[[condition]]\nminutes = 1\npolicy = \"trl\"\nset.policy.threshold = 75\n"
                          "set.policy.epsilon = 0.1\nset.agent.step_size = 0.7\nset.agent.discount = 0.96\n"
                          "set.environment.goal_reward = 400\n");
  ASSERT_TRUE(plan) << plan.error().message;
  ASSERT_TRUE(plan->conditions[0].preLearning);
  const Configuration& pre = plan->conditions[0].preLearning->configuration;
  EXPECT_EQ(pre.names.policy, "epsilon-greedy");
  EXPECT_EQ(pre.names.scenario, "2");
  EXPECT_EQ(pre.parameters.get("policy.epsilon"), 0.05);
  EXPECT_EQ(pre.parameters.get("agent.step_size"), 0.4);
  EXPECT_EQ(pre.parameters.get("agent.discount"), 0.96);
  EXPECT_EQ(pre.parameters.get("environment.goal_reward"), 400);
  EXPECT_EQ(pre.until, 198);
  EXPECT_EQ(pre.episodes, 20'000);
  EXPECT_EQ(plan->conditions[0].configuration.names.scenario, "actual");
}

TEST(Plan, ConditionsWithTheSamePreLearningShareIt) {
  const auto plan = parse(kPre +
                          "[[condition]]\nminutes = 1\npolicy = \"trl\"\nset.policy.threshold = [0, 50]\n"
                          "[[condition]]\nminutes = 1\nname = \"none\"\npre-learning = false\n");
  ASSERT_TRUE(plan) << plan.error().message;
  const auto& c = plan->conditions;
  EXPECT_EQ(c[0].preLearning->text, c[1].preLearning->text);
  EXPECT_EQ(c[0].preLearning->configuration.seed, c[1].preLearning->configuration.seed);
  EXPECT_NE(c[0].configuration.seed, c[1].configuration.seed);
  EXPECT_FALSE(c[2].preLearning);
}

TEST(Plan, APoolServesLivesInTurn) {
  PreLearning pre;
  pre.pool = 5;
  EXPECT_EQ(pre.numberFor(0), 0);
  EXPECT_EQ(pre.numberFor(7), 2);
  pre.pool = 0;
  EXPECT_EQ(pre.numberFor(7), 7);
}

TEST(Plan, ReferencesAreFilledInLikeNames) {
  const auto plan = parse(
      "[base]\nminutes = 1\nscenario = [\"2\", \"3\"]\nreference = \"{scenario}: greedy\"\n"
      "[[condition]]\nname = \"{scenario}: greedy\"\npolicy = \"greedy\"\n"
      "[[condition]]\nname = \"{scenario}: τ 1\"\npolicy = \"softmax\"\n");
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->conditions[3].name, "3: τ 1");
  EXPECT_EQ(plan->conditions[3].reference, "3: greedy");
}

TEST(Plan, TheCommandLineHasTheLastWord) {
  const auto plan = parse("lives = 5\nseed = 3\n[[condition]]\nminutes = 1\nset.agent.trace_decay = 0.5\n",
                          {.lives = 7, .seed = 9, .assignments = {{"agent.trace_decay", "0.9"}}});
  EXPECT_EQ(plan->lives, 7);
  EXPECT_EQ(plan->seed, 9u);
  EXPECT_EQ(plan->conditions[0].configuration.parameters.get("agent.trace_decay"), 0.9);
}

TEST(Plan, WhatIsWrongIsNamedWithItsLine) {
  expectRefusal("lives = 3\n", {"[[condition]]"});
  expectRefusal("lives = \n", {"line 1", "TOML"});
  expectRefusal("lifes = 3\n[[condition]]\nminutes = 1\n", {"line 1", "lifes", "did you mean lives"});
  expectRefusal("lives = 0\n[[condition]]\nminutes = 1\n", {"line 1", "lives", "0"});
  expectRefusal("[[condition]]\nminutes = 1\npolcy = \"trl\"\n", {"line 3", "polcy", "did you mean policy"});
  expectRefusal("[[condition]]\nminutes = -1\n", {"line 2", "minutes"});
  expectRefusal("[[condition]]\nname = \"x\"\n", {"how long"});
  expectRefusal("[[condition]]\nminutes = 1\npolicy = \"trl\"\nset.policy.temperature = 1\n",
                {"policy.temperature", "no effect"});
  expectRefusal("[[condition]]\nminutes = 1\nset.policy.epsilon = 2\n", {"policy.epsilon", "2", "0 to 1"});
  expectRefusal("[[condition]]\nminutes = 1\nset.policy.epsilon = [0.1, 0.1]\n", {"line 3", "twice"});
  expectRefusal("[[condition]]\nminutes = 1\nset.policy.epsilon = []\n", {"line 3", "list"});
  expectRefusal("[[condition]]\nminutes = 1\nset.policy.epsilon = 1979-05-27\n", {"line 3", "number"});
  expectRefusal("[[condition]]\nminutes = 1\n[[condition]]\nminutes = 1\n", {"two conditions"});
  expectRefusal("[[condition]]\nname = \"a\"\nminutes = 1\n[[condition]]\nname = \"b\"\nminutes = 1\n", {"the same"});
  expectRefusal("reference = \"c\"\n[[condition]]\nname = \"a\"\nminutes = 1\n", {"reference", "c"});
  expectRefusal(kPre + "pool = 0\n[[condition]]\nminutes = 1\n", {"pre-learning", "pool"});
  expectRefusal(kPre + "set.features.tilings = 8\n[[condition]]\nminutes = 1\n", {"pre-learning", "tilings", "8"});
  expectRefusal("[[condition]]\nminutes = 1\nname = \"{environment.foo}\"\n", {"line 3", "{environment.foo}"});
  expectRefusal(kPre + "file = \"q.safetensors\"\n[[condition]]\nminutes = 1\n", {"pre-learning", "file"});
  expectRefusal("[pre-learning]\nfile = \"q.safetensors\"\n[[condition]]\nminutes = 1\n", {"q.safetensors"});
  expectRefusal("[[condition]]\nminutes = 1\nset = 5\n", {"line 3", "set.features.scale"});
  expectRefusal("[[condition]]\nminutes = 1\npre-learning = true\n", {"line 3", "false", "pre-learning.scenario"});
  expectRefusal("[[condition]]\nminutes = 1\npre-learning.minutes = 0\n", {"line 3", "minutes", "0"});
  expectRefusal("condition = 3\n", {"condition"});
  expectRefusal("[[condition]]\nminutes = 1\nset.a.b.c.d.e.f.g.h.i.j = 1\n", {"deep"});
}

}  // namespace surefoot
