// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold of everything in the registry, whoever adds it.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/glossary.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

/// All but the hand-made controller where there is none, which is refused with a word; and tables that fit a test.
bool isRefused(const Registry& r, const Names& names) {
  const auto environment = (*findEntry(r.environments, "environment", names.environment))->make();
  if (names.agent != "scripted" || environment->task().handMade) return false;
  const auto configuration = configure(r, names, {});
  EXPECT_FALSE(configuration);
  EXPECT_NE(configuration.error().message.find("hand-made"), std::string::npos);
  return true;
}

/// Small tables where they would be hashed in large ones.
std::vector<Assignment> smallTables(const Registry& r, const Names& names, std::vector<Assignment> more = {}) {
  const auto configuration = configure(r, names, {});
  if (configuration)
    for (const char* key : {"features.memory", "positive.memory", "negative.memory", "shaping.memory"})
      if (configuration->parameters.find(key) && names.environment == "leo") more.push_back({key, "4096"});
  return more;
}

template <class Entry>
void expectGoodNames(const std::vector<Entry>& entries) {
  std::set<std::string> names;
  for (const Entry& e : entries) {
    EXPECT_TRUE(names.insert(e.name).second) << e.name << " is there twice";
    EXPECT_EQ(e.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string::npos) << e.name;
    EXPECT_FALSE(e.title.empty()) << e.name;
    EXPECT_TRUE(e.help.ends_with('.')) << e.name << ": " << e.help;
  }
  EXPECT_FALSE(entries.empty());
}

}  // namespace

TEST(Contract, EveryNameIsUniqueAndExplained) {
  const Registry r = fullRegistry();
  expectGoodNames(r.environments);
  expectGoodNames(r.features);
  expectGoodNames(r.agents);
  expectGoodNames(r.policies);
  expectGoodNames(r.presets);
  expectGoodNames(r.scenarios);
  const auto expectWords = [](const auto& entries) {  // Help › Words and `surefoot list`
    for (const auto& e : entries) EXPECT_TRUE(wordOf(e.name)) << e.name << " has no word in core/glossary.cpp";
  };
  expectWords(r.environments), expectWords(r.features), expectWords(r.agents), expectWords(r.policies);
}

TEST(Contract, EveryParameterHasTitleHelpOriginAndADefaultInRange) {
  const Registry r = fullRegistry();
  for (const EnvironmentEntry& environment : r.environments) {
    Names names;
    names.environment = environment.name;
    const auto configuration = configure(r, names, {});
    ASSERT_TRUE(configuration);
    for (const auto& [p, value, usual] : configuration->parameters.all()) {
      EXPECT_FALSE(p.title.empty()) << p.key;
      EXPECT_TRUE(p.help.ends_with('.')) << p.key;
      EXPECT_FALSE(p.origin.empty()) << p.key;
      EXPECT_TRUE(checkValue(p, p.fallback)) << p.key;
      EXPECT_LE(p.low, p.sliderLow) << p.key;
      EXPECT_LE(p.sliderHigh, p.high) << p.key;
      EXPECT_LT(p.sliderLow, p.sliderHigh) << p.key;
      EXPECT_LE(p.sliderLow, p.fallback) << p.key;
      EXPECT_LE(p.fallback, p.sliderHigh) << p.key;
      if (p.needs.empty()) continue;
      const Parameters::Entry* choice = configuration->parameters.find(p.needs);
      ASSERT_TRUE(choice) << p.key << " needs " << p.needs;
      EXPECT_TRUE(choice->parameter.kind == Kind::Choice || choice->parameter.low == 0.0) << p.needs << ": 0 is off";
      for (const std::string& name : p.needsOne) EXPECT_TRUE(parseValue(choice->parameter, name)) << p.key;
    }
  }
}

TEST(Contract, EveryPolicyIsADistributionForAnyValues) {
  const Registry r = fullRegistry();
  Random random(23);
  for (const PolicyEntry& entry : r.policies) {
    const auto policy = entry.make();
    for (int trial = 0; trial < 2000; ++trial) {
      std::vector<double> q(1 + random.next() % 12), pi(q.size());
      const double scale = std::pow(10.0, random.uniform(-3, 6));
      for (double& value : q)
        value = trial % 3 == 0 ? std::floor(random.uniform(-2, 2)) : random.uniform(-scale, scale);
      policy->probabilities({.q = q}, pi);
      double sum = 0;
      for (const double p : pi) {
        ASSERT_GE(p, 0.0) << entry.name;
        sum += p;
      }
      ASSERT_NEAR(sum, 1.0, 1e-12) << entry.name;
      const auto best = std::max_element(q.begin(), q.end()) - q.begin();
      for (const double p : pi)
        ASSERT_LE(p, pi[static_cast<std::size_t>(best)] + 1e-12) << entry.name << ": the best action is the likeliest";
    }
  }
}

TEST(Contract, EveryPolicyTakesTheMostActionsThereMayBe) {
  std::vector<double> q(kMaxActions), pi(kMaxActions);
  for (std::size_t a = 0; a < q.size(); ++a) q[a] = static_cast<double>(a);
  for (const PolicyEntry& entry : fullRegistry().policies) {
    entry.make()->probabilities({.q = q}, pi);
    double sum = 0;
    for (const double p : pi) sum += p;
    EXPECT_NEAR(sum, 1.0, 1e-9) << entry.name;
  }
}

TEST(Contract, EveryEnvironmentKeepsItsWord) {
  for (const EnvironmentEntry& entry : fullRegistry().environments) {
    const auto environment = entry.make();
    const Task& task = environment->task();
    ASSERT_FALSE(task.actions.empty());
    ASSERT_LE(task.rewardTerms.size(), static_cast<std::size_t>(kMaxTaskTerms));
    Fields fields("");
    environment->declare(fields);
    for (const auto& field : fields.all())
      if (field.parameter.key == "max_steps") field.set(1000);  // random actions may never reach the goal
    environment->parametersChanged();
    Random random(5);
    int endings = 0;
    environment->reset(random);
    for (int step = 0; step < 20'000; ++step) {
      ASSERT_EQ(environment->state().size(), task.state.size());
      for (const double x : environment->state()) ASSERT_TRUE(std::isfinite(x));
      const Outcome o = environment->step(static_cast<Action>(random.next() % task.actions.size()));
      double sum = 0;
      for (std::size_t i = 0; i < task.rewardTerms.size(); ++i) sum += o.terms[i];
      ASSERT_DOUBLE_EQ(o.reward, sum);
      if (o.ending != Ending::None) ++endings, environment->reset(random);
    }
    EXPECT_GT(endings, 0) << entry.name;
    Scene scene;
    environment->draw(environment->pose(), scene);
    EXPECT_FALSE(scene.shapes.empty());
    EXPECT_FALSE(environment->readOuts(environment->pose()).empty());
  }
}

TEST(Contract, EveryPresetAndScenarioConfigures) {
  const Registry r = fullRegistry();
  for (const auto* list : {&r.presets, &r.scenarios})
    for (const AssignmentEntry& entry : *list) {
      Names names;
      names.environment = entry.environment;
      (list == &r.presets ? names.preset : names.scenario) = entry.name;
      const auto configuration = configure(r, names, {});
      ASSERT_TRUE(configuration) << configuration.error().message;
      for (const auto& [key, value] : entry.values)
        if (configuration->parameters.find(key)) {  // some are for other learning rules
          EXPECT_EQ(configuration->parameters.get(key), value);
        }
    }
}

// Any environment with any features that fit, and a misfit is refused with the reason.
TEST(Contract, EveryAgentLearnsOnEveryFeatureMapThatFits) {
  const Registry r = fullRegistry();
  for (const EnvironmentEntry& environment : r.environments)
    for (const FeatureEntry& features : r.features)
      for (const AgentEntry& agent : r.agents) {
        Names names;
        names.environment = environment.name, names.agent = agent.name, names.features = features.name;
        if (isRefused(r, names)) continue;
        const std::vector<Assignment> shaped =
            agent.name == "scripted" ? std::vector<Assignment>() : std::vector<Assignment>{{"shaping.rewards", "all"}};
        auto configuration = configure(r, names, smallTables(r, names, shaped));
        ASSERT_TRUE(configuration) << configuration.error().message;
        configuration->episodes = 3;
        auto life = makeLife(r, *configuration, 0, false);
        if (!life) {
          // Tables are for states of whole numbers, and radial bases for few state variables.
          const bool wide = environment.name == "leo" && features.name == "radial-basis";
          EXPECT_TRUE(features.name == "table" || wide) << life.error().message;
          EXPECT_NE(life.error().message.find(wide ? "centres" : "whole numbers"), std::string::npos)
              << life.error().message;
          continue;
        }
        while (!(*life)->finished()) (*life)->step();
        EXPECT_EQ((*life)->log().totals().episodes, 3) << environment.name << " " << agent.name << " " << features.name;
      }
}

// Looking at a learner changes nothing: two equal lives, one of them watched all the time.
TEST(Contract, LookingDoesNotTouchTheLearner) {
  const Registry r = fullRegistry();
  for (const EnvironmentEntry& environment : r.environments)
    for (const AgentEntry& agent : r.agents)
      for (const PolicyEntry& policy : r.policies) {
        Names names;
        names.environment = environment.name, names.agent = agent.name, names.policy = policy.name;
        if (isRefused(r, names)) continue;
        auto configuration = configure(r, names, smallTables(r, names));
        ASSERT_TRUE(configuration);
        configuration->episodes = 30;
        auto watched = makeLife(r, *configuration, 0, true), alone = makeLife(r, *configuration, 0, false);
        ASSERT_TRUE(watched && alone);
        std::vector<double> q((*watched)->environment().task().actions.size());
        std::vector<Eligibility> z;
        const auto follows = (*watched)->agent().values().clone();
        constexpr std::int64_t kLong = 2000;
        while (!(*watched)->finished() && (*watched)->steps() < kLong) {
          (*watched)->step();
          const auto& values = (*watched)->agent().values();
          for (const Layer layer : {Layer::Sum, Layer::Positive, Layer::Negative})
            values.evaluate((*watched)->environment().state(), layer, q);
          if ((*watched)->steps() % 50 == 0)
            (*watched)->agent().eligibility(z), values.average(z, (*watched)->environment().state(), q);
          if ((*watched)->steps() % 500 == 0) {  // a copy of what changed is as good as a copy of everything
            follows->assign(values);
            ASSERT_EQ(follows->tables(), values.clone()->tables()) << environment.name << " " << agent.name;
            ASSERT_EQ(follows->visits((*watched)->environment().state()),
                      values.visits((*watched)->environment().state()));
          }
        }
        while (!(*alone)->finished() && (*alone)->steps() < kLong) (*alone)->step();
        EXPECT_EQ((*watched)->hash(), (*alone)->hash()) << environment.name << " " << agent.name << " " << policy.name;
      }
}

}  // namespace surefoot
