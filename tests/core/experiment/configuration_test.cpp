// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

TEST(Configuration, DefaultsAreTheThesiss) {
  const Configuration c = pendulumConfiguration(fullRegistry());
  EXPECT_EQ(c.parameters.get("agent.step_size"), 0.4);
  EXPECT_EQ(c.parameters.get("agent.discount"), 0.98);
  EXPECT_EQ(c.parameters.get("agent.trace_decay"), 0.92);
  EXPECT_EQ(c.parameters.get("policy.epsilon"), 0.05);
  EXPECT_EQ(c.parameters.get("policy.below"), 0.01);
  EXPECT_EQ(c.parameters.get("features.tilings"), 16);
  EXPECT_EQ(c.parameters.get("features.pole_angle"), 12);
  EXPECT_EQ(c.parameters.get("features.pole_rate"), 6);
  EXPECT_EQ(c.parameters.get("features.wheel_rate"), 6);
  EXPECT_EQ(c.parameters.get("features.initial_high"), 0.1);
}

TEST(Configuration, AssignmentsWinOverScenarioAndPreset) {
  const Registry r = fullRegistry();
  Names names;
  names.preset = "lab";
  names.scenario = "2";
  const auto c = configure(r, names, {{"environment.damping", "0.05"}});
  ASSERT_TRUE(c);
  EXPECT_EQ(c->parameters.get("environment.damping"), 0.05);
  EXPECT_EQ(c->parameters.get("environment.friction"), 0.02);
  EXPECT_EQ(c->parameters.get("environment.pole_length"), 0.4);
}

TEST(Configuration, AnUnknownNameSuggestsTheNearest) {
  Names names;
  names.policy = "softmx";
  const auto c = configure(fullRegistry(), names, {});
  ASSERT_FALSE(c);
  EXPECT_NE(c.error().message.find("did you mean softmax"), std::string::npos) << c.error().message;
}

TEST(Configuration, LivesOfOneSeedDifferAndRepeat) {
  const Registry r = fullRegistry();
  Configuration c = pendulumConfiguration(r);
  c.episodes = 20;
  const auto hash = [&](int index) {
    auto life = makeLife(r, c, index, false);
    while (!(*life)->finished()) (*life)->step();
    return (*life)->hash();
  };
  EXPECT_EQ(hash(0), hash(0));
  EXPECT_NE(hash(0), hash(1));
  c.seed = 2;
  EXPECT_NE(hash(0), hash(1));
}

TEST(Configuration, AnInitialRangeTheWrongWayRoundIsRefused) {
  const Registry r = fullRegistry();
  const Configuration c = pendulumConfiguration(r, "greedy", {{"features.initial_low", "5"}});
  EXPECT_FALSE(makeLife(r, c, 0, false));
}

}  // namespace surefoot
