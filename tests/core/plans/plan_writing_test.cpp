// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that the program writes run, and run what they say, whatever else the plan holds.
#include "core/plans/plan_writing.h"

#include <cmath>
#include <filesystem>

#include "core/files/whole_file.h"
#include "core/plans/plan_time.h"
#include "core/saved/q_file.h"
#include "tests/core/experiment/test_setup.h"
#include "tests/folder.h"

namespace surefoot {

namespace {

/// Everything that a condition without settings of its own would take over, or be refused for.
const std::string kNasty =
    "reference = \"other\"\nlives = 2\n"
    "[base]\nenvironment = \"cliff\"\nfeatures = \"table\"\npolicy = \"softmax\"\nagent = \"q-learning\"\n"
    "episodes = 7\nset.policy.temperature = 2\nset.agent.step_size = 0.1\n"
    "[pre-learning]\nuntil = -50\ncap = 3\npool = 2\n"
    "[[condition]]\nname = \"other\"\n";

/// Another value that is allowed.
double otherValue(const Parameter& p, double value) {
  if (p.kind == Kind::Choice) return value == p.low ? p.high : p.low;
  const double middle = value + 0.37 * (p.high - value);
  const double near = std::isfinite(middle) && std::abs(middle) < 1e6 ? middle : value * 1.1 + 0.013;
  return p.kind == Kind::Integer ? std::min(p.high, value + 1) : std::clamp(near, p.low, p.high);
}

bool lives(const Registry& registry, const Configuration& c) {
  return static_cast<bool>(makeLife(registry, c, 0, false));
}

/// Every third parameter that may be changed has another value.
Configuration changed(const Registry& registry, Configuration c, std::size_t offset) {
  const auto keys = policyKeys(**findEntry(registry.policies, "policy", c.names.policy));
  for (std::size_t i = offset; i < c.parameters.all().size(); i += 3) {
    const Parameter p = c.parameters.all()[i].parameter;
    const bool foreign = p.key.starts_with("policy.") && std::find(keys.begin(), keys.end(), p.key) == keys.end();
    Configuration other = c;
    const double value = otherValue(p, c.parameters.get(p.key));
    // A table of LEO's may become larger than memory.
    if (p.when == When::NewTable && c.names.environment == "leo") continue;
    if (!other.parameters.set(p.key, value)) continue;
    if (foreign || makeEnvironment(registry, other)) c = std::move(other);
  }
  return c;
}

void expectSame(const Registry& registry, const Configuration& live, const Condition& planned,
                const std::string& toml) {
  const Configuration& c = planned.configuration;
  EXPECT_EQ(describe(registry, c), describe(registry, live)) << toml;
  EXPECT_FALSE(planned.preLearning) << toml;
  const auto keys = policyKeys(**findEntry(registry.policies, "policy", live.names.policy));
  for (const auto& entry : live.parameters.all()) {
    const std::string& key = entry.parameter.key;
    if (key.starts_with("policy.") && std::find(keys.begin(), keys.end(), key) == keys.end()) continue;
    ASSERT_TRUE(c.parameters.find(key)) << key;
    EXPECT_EQ(c.parameters.get(key), entry.value) << key << "\n" << toml;
  }
}

}  // namespace

TEST(PlanWriting, ABlockRunsExactlyWhatAConfigurationSaysWhateverBaseHolds) {
  const Registry registry = fullRegistry();
  int tried = 0, walkers = 0;
  for (const auto& environment : registry.environments)
    for (const auto& agent : registry.agents)
      for (const auto& policy : registry.policies)
        for (const auto& features : registry.features) {
          Names names;
          names.environment = environment.name, names.agent = agent.name;
          names.policy = policy.name, names.features = features.name;
          const auto usual = configure(registry, names, {});
          if (!usual || !lives(registry, *usual)) continue;
          if (environment.name == "leo" && ++walkers % 16 != 1) continue;  // its tables take their time
          Configuration live = changed(registry, *usual, static_cast<std::size_t>(tried % 3));
          if (!lives(registry, live)) live = *usual;
          const auto toml = conditionToml(registry, live, "live: \"" + policy.name + "\"");
          ASSERT_TRUE(toml) << toml.error().message;
          const auto plan = parsePlan(registry, kNasty + *toml, "plan.toml", {});
          ASSERT_TRUE(plan) << plan.error().message << "\n" << *toml;
          ASSERT_EQ(plan->conditions.size(), 2u);
          expectSame(registry, live, plan->conditions[1], *toml);
          const bool clock = (*makeEnvironment(registry, live))->task().stepTime.has_value();
          EXPECT_EQ(plan->conditions[1].configuration.minutes.has_value(), clock);
          EXPECT_EQ(plan->conditions[1].configuration.episodes.has_value(), !clock) << "7 are [base]'s";
          ++tried;
          break;  // one representation that the task takes
        }
  EXPECT_GT(tried, 60);
}

TEST(PlanWriting, ALifeIsAsLongAsTheConfigurationSays) {
  const Registry registry = fullRegistry();
  Configuration live = pendulumConfiguration(registry);
  live.minutes = 1.25;
  live.episodes = 30;
  const auto plan = parsePlan(registry, kNasty + *conditionToml(registry, live, "live"), "plan.toml", {});
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->conditions[1].configuration.minutes, 1.25);
  EXPECT_EQ(plan->conditions[1].configuration.episodes, 30);
  EXPECT_EQ(freeName(*plan, "live"), "live (2)");
  EXPECT_EQ(freeName(*plan, "another"), "another");
}

namespace {

/// What a life has learned by episode 30, in another world than `live`.
std::shared_ptr<TensorFile> learnedBefore(const Registry& registry, Configuration simulation) {
  simulation.until = -20;
  simulation.episodes = 30;
  const auto life = lifeOf(registry, simulation);
  while (!life->finished()) life->step();
  return std::make_shared<TensorFile>(qFileOf(*life, simulation));
}

Result<Plan> planWith(const Registry& registry, const Configuration& live) {
  const auto toml = conditionToml(registry, live, "live");
  if (!toml) return toml.error();
  return parsePlan(registry, kNasty + *toml, "plan.toml", {});
}

}  // namespace

TEST(PlanWriting, APreLearnedLifeIsWrittenWithHowItWasPreLearned) {
  const Registry registry = fullRegistry();
  Configuration live = pendulumConfiguration(registry, "trl", {{"features.tilings", "8"}, {"agent.step_size", "0.3"}});
  Configuration simulation = live;
  simulation.names.policy = "epsilon-greedy";
  simulation.names.scenario = "2";
  ASSERT_TRUE(simulation.parameters.set("environment.damping", 0.004)) << "as the dialog leaves it to be set";
  ASSERT_TRUE(simulation.parameters.set("policy.epsilon", 0.2));
  beginWith(live, learnedBefore(registry, simulation));
  const auto plan = planWith(registry, live);
  ASSERT_TRUE(plan) << plan.error().message;
  const auto& before = plan->conditions[1].preLearning;
  ASSERT_TRUE(before);
  EXPECT_EQ(describe(registry, before->configuration), describe(registry, simulation));
  EXPECT_EQ(before->configuration.until, -20);
  EXPECT_EQ(before->configuration.episodes, 30);
  EXPECT_EQ(describe(registry, plan->conditions[1].configuration), describe(registry, live));
}

TEST(PlanWriting, ALifeThatBeganWithAFileIsWrittenWithThatFileOrRefused) {
  const Registry registry = fullRegistry();
  Configuration live = pendulumConfiguration(registry);
  const Folder folder;
  const std::string path = folder.file("plan_writing_test.safetensors");
  const auto file = learnedBefore(registry, live);
  ASSERT_TRUE(writeWhole("file", path, file->write()));
  beginWith(live, *readQFile(path));
  const auto plan = planWith(registry, live);
  ASSERT_TRUE(plan) << plan.error().message;
  const Configuration& planned = plan->conditions[1].configuration;
  ASSERT_TRUE(planned.start);
  EXPECT_EQ(contentOf(*planned.start), contentOf(*file));

  Configuration other = pendulumConfiguration(registry);
  other.seed = 2;
  ASSERT_TRUE(writeWhole("file", path, learnedBefore(registry, other)->write()));
  EXPECT_NE(planWith(registry, live).error().message.find("other values"), std::string::npos);
  std::filesystem::remove(path);
  EXPECT_NE(planWith(registry, live).error().message.find("plan_writing_test.safetensors"), std::string::npos);
}

TEST(PlanWriting, WhatNoPlanCanSayIsRefused) {
  const Registry registry = fullRegistry();
  Configuration live = pendulumConfiguration(registry);
  auto carried = learnedBefore(registry, live);
  carried->about["learned"] = {{"carried_over", true}};
  Configuration over = live;
  beginWith(over, carried);
  EXPECT_NE(planWith(registry, over).error().message.find("carried over"), std::string::npos);

  Configuration session = live;  // a session that was opened tells what it began with, and has it no more
  session.beganWith = {{"file", "walks.safetensors"}, {"content", "0"}};
  EXPECT_NE(planWith(registry, session).error().message.find("walks.safetensors"), std::string::npos);

  Configuration elsewhere = pendulumConfiguration(registry, "epsilon-greedy", {});
  auto other = learnedBefore(registry, live);
  other->about["configuration"]["agent"] = "q-learning";
  beginWith(elsewhere, other);
  EXPECT_NE(planWith(registry, elsewhere).error().message.find("learning rule"), std::string::npos);
}

TEST(PlanWriting, BaseInAConditionIsFalseOrRefused) {
  const Registry registry = fullRegistry();
  const auto plan = parsePlan(registry, "[[condition]]\nname = \"a\"\nminutes = 1\nbase = true\n", "plan.toml", {});
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.error().message.find("base = true"), std::string::npos) << plan.error().message;
}

TEST(PlanTime, GrowsWithLivesAndLengthAndBelievesWhatWasMeasured) {
  const Registry registry = fullRegistry();
  const auto minutes = [&](const std::string& head, const std::string& more, int threads) {
    const auto file = parsePlanFile(head + "[[condition]]\nname = \"a\"\nminutes = 9\n" + more, "plan.toml");
    EXPECT_TRUE(file);
    return minutesFor(registry, *file, threads);
  };
  const double one = minutes("lives = 10\n", "", 1);
  EXPECT_GT(one, 0);
  EXPECT_DOUBLE_EQ(minutes("lives = 20\n", "", 1), 2 * one);
  EXPECT_DOUBLE_EQ(minutes("lives = 20\n", "", 2), one);
  EXPECT_DOUBLE_EQ(minutes("lives = 10\n", "policy = \"trl\"\nset.policy.threshold = [0, 50, 100]\n", 1), 3 * one);
  EXPECT_GT(minutes("lives = 10\n", "pre-learning.until = 198\npre-learning.scenario = \"2\"\n", 1), one);
  EXPECT_DOUBLE_EQ(minutes("minutes_on_two_cores = 56\n", "", 4), 28);
  const std::string measured = "minutes_on_two_cores = 56\nminutes_for_lives = 40\n";
  EXPECT_DOUBLE_EQ(minutes(measured, "", 4), 28);
  EXPECT_DOUBLE_EQ(minutes(measured + "lives = 20\n", "", 4), 14) << "another number of lives";
  EXPECT_DOUBLE_EQ(minutes(measured + "lives = 1\n", "", 2), 1.4);
  EXPECT_EQ(roundedTime(0.001), "1 s");
  EXPECT_EQ(roundedTime(0.3), "20 s");
  EXPECT_EQ(roundedTime(4.2), "4 min");
  EXPECT_EQ(roundedTime(130), "2 h 10 min");
}

}  // namespace surefoot
