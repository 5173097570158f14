// SPDX-License-Identifier: GPL-3.0-or-later
// What walkers have and the pendulum has not: measures of an episode, greedy tests, a rule of thumb without a goal, and
// three hundred actions.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/experiment/experiment.h"
#include "core/findings/evidence.h"
#include "core/laboratory/laboratory.h"
#include "core/life/rule_of_thumb.h"
#include "core/policies/greedy.h"
#include "core/saved/checkpoint.h"
#include "core/store/csv_export.h"
#include "tests/core/experiment/test_setup.h"
#include "tests/folder.h"

namespace surefoot {

namespace {

Configuration walker(const Registry& registry, const std::string& environment, const std::string& agent = "sarsa",
                     const std::vector<Assignment>& assignments = {}) {
  Names names;
  names.environment = environment;
  names.agent = agent;
  auto configuration = configure(registry, names, assignments);
  EXPECT_TRUE(configuration) << configuration.error().message;
  return *configuration;
}

double named(const std::vector<NamedValue>& values, const std::string& name) {
  for (const NamedValue& v : values)
    if (v.name == name) return v.value;
  return std::nan("");
}

}  // namespace

TEST(Walking, MeasuresOfALifeAreTheSumsOfItsEpisodes) {
  const Registry registry = fullRegistry();
  Configuration c = walker(registry, "compass");
  c.episodes = 45;
  const auto life = makeLife(registry, c, 0, true);
  while (!(*life)->finished()) (*life)->step();
  EpisodeMeasures sum{};
  for (const EpisodeRow& row : (*life)->log().rows())
    for (std::size_t m = 0; m < kMaxMeasures; ++m) sum[m] += row.measures[m];
  for (std::size_t m = 0; m < kMaxMeasures; ++m) EXPECT_DOUBLE_EQ((*life)->log().totals().measures[m], sum[m]);

  const LifeResult result = summarise(**life, 0, 0.0);
  const auto values = measuresOf(result);
  EXPECT_DOUBLE_EQ(named(values, "distance"), sum[0]);
  EXPECT_DOUBLE_EQ(named(values, "net_footsteps"), sum[1]);
  EXPECT_NEAR(named(values, "falls_per_hour") * result.simulatedSeconds / 3600,
              static_cast<double>(result.totals.falls), 1e-9);
}

// After every tenth episode, with the values as they are then, from a start of its own; nothing of it is counted.
TEST(Walking, GreedyTestsAreEpisodesThatDoNotCount) {
  const Registry registry = fullRegistry();
  Configuration c = walker(registry, "compass");
  c.episodes = 45;
  const auto life = makeLife(registry, c, 0, true);
  std::unique_ptr<ActionValueFunction> values;
  while (!(*life)->finished()) {
    (*life)->step();
    if ((*life)->log().totals().episodes == 20 && !values) values = (*life)->agent().values().clone();
  }
  const auto& tests = (*life)->greedyTests();
  ASSERT_EQ(tests.size(), 4u);
  for (std::size_t i = 0; i < tests.size(); ++i) EXPECT_EQ(tests[i].episode, 10 * static_cast<int>(i + 1));
  EXPECT_EQ((*life)->log().rows().size(), 45u);

  auto environment = makeEnvironment(registry, c);
  GreedyTester again(std::move(*environment), deriveSeed(c.seed, 0, Stream::Tests));
  again.test(*values, Greedy(), 20, 0);
  EXPECT_EQ(again.tests()[0].steps, tests[1].steps);
  EXPECT_EQ(again.tests()[0].reward, tests[1].reward);
  EXPECT_EQ(again.tests()[0].measures, tests[1].measures);
}

TEST(Walking, TheHandMadeControllerIsNotTested) {
  const Registry registry = fullRegistry();
  Configuration c = walker(registry, "leo", "scripted");
  c.episodes = 10;
  Parameters& p = c.parameters;
  ASSERT_TRUE(p.set("environment.max_steps", 30.0));
  const auto life = makeLife(registry, c, 0, true);
  while (!(*life)->finished()) (*life)->step();
  EXPECT_TRUE((*life)->greedyTests().empty());
  EXPECT_GT((*life)->log().totals().measures[0], 0.0) << "it walks forward";
  EXPECT_GT((*life)->log().totals().measures[2], 0.0) << "which takes energy";
}

TEST(Walking, ASavedLifeKeepsItsTestsAndGoesOnTesting) {
  const Registry registry = fullRegistry();
  Configuration c = walker(registry, "compass");
  c.episodes = 40;
  const auto whole = makeLife(registry, c, 0, true), first = makeLife(registry, c, 0, true);
  (*first)->keepInputs();
  while (!(*whole)->finished()) (*whole)->step();
  while ((*first)->log().totals().episodes < 25) (*first)->step();
  (*first)->step();
  auto file = TensorFile::parse(checkpointOf(**first, c, true).write(), "life");
  ASSERT_TRUE(file);
  auto resumed = resume(registry, std::make_shared<const TensorFile>(std::move(*file)), {});
  ASSERT_TRUE(resumed) << resumed.error().message;
  Life& life = *resumed->life;
  while (!life.finished()) life.step();
  EXPECT_EQ(life.hash(), (*whole)->hash());
  ASSERT_EQ(life.greedyTests().size(), (*whole)->greedyTests().size());
  for (std::size_t i = 0; i < life.greedyTests().size(); ++i)
    EXPECT_EQ(life.greedyTests()[i].reward, (*whole)->greedyTests()[i].reward) << i;
}

TEST(Walking, ARewardThatChangesInAnEpisodeHoldsForItsTestSavedOrNot) {
  const Registry registry = fullRegistry();
  Configuration c = walker(registry, "compass");
  c.episodes = 10;
  const auto life = makeLife(registry, c, 0, true);
  (*life)->keepInputs();
  while ((*life)->log().totals().episodes < 9) (*life)->step();
  (*life)->step();
  ASSERT_TRUE((*life)->set("environment.fall_reward", -777.0));
  Configuration now = c;
  now.parameters = (*life)->parameters();
  auto file = TensorFile::parse(checkpointOf(**life, now, true).write(), "life");
  ASSERT_TRUE(file);
  auto resumed = resume(registry, std::make_shared<const TensorFile>(std::move(*file)), {});
  ASSERT_TRUE(resumed) << resumed.error().message;
  for (Life* one : {life->get(), resumed->life.get()})
    while (!one->finished()) one->step();
  ASSERT_EQ((*life)->greedyTests().size(), 1u);
  ASSERT_GT((*life)->greedyTests()[0].falls, 0);
  EXPECT_LT((*life)->greedyTests()[0].reward, -500);
  EXPECT_EQ(resumed->life->greedyTests()[0].reward, (*life)->greedyTests()[0].reward);
}

TEST(Walking, ASavedLifeOfTheHandMadeControllerGoesOn) {
  const Registry registry = fullRegistry();
  Configuration c = walker(registry, "leo", "scripted");
  c.episodes = 3;
  ASSERT_TRUE(c.parameters.set("environment.max_steps", 60.0));
  const auto whole = makeLife(registry, c, 0, true), first = makeLife(registry, c, 0, true);
  (*first)->keepInputs();
  while (!(*whole)->finished()) (*whole)->step();
  for (int i = 0; i < 100; ++i) (*first)->step();
  auto file = TensorFile::parse(checkpointOf(**first, c, true).write(), "life");
  ASSERT_TRUE(file);
  auto resumed = resume(registry, std::make_shared<const TensorFile>(std::move(*file)), {});
  ASSERT_TRUE(resumed) << resumed.error().message;
  while (!resumed->life->finished()) resumed->life->step();
  EXPECT_EQ(resumed->life->hash(), (*whole)->hash());
}

// Thesis, section 4.5: the highest intermediate reward in place of the goal's; from footstep to footstep.
TEST(Walking, TheRuleOfThumbGoesByTheHighestRewardOfAStep) {
  const Registry registry = fullRegistry();
  Configuration c = walker(registry, "compass");
  c.episodes = 60;
  const auto life = makeLife(registry, c, 0, true);
  double highest = -1e9;
  while (!(*life)->finished()) (*life)->step();
  for (const EpisodeRow& row : (*life)->log().rows()) highest = std::max(highest, row.highest);
  const double footsteps = (*life)->log().totals().measures[1];
  ASSERT_GT(footsteps, 0);
  const auto rule = ruleOfThumbOf(**life);
  ASSERT_TRUE(rule);
  const double n = static_cast<double>((*life)->steps()) / footsteps, gamma = 0.99;
  EXPECT_DOUBLE_EQ(rule->transitions, n);
  const double power = std::pow(gamma, n);
  EXPECT_NEAR(rule->threshold, power * highest - gamma * (1 - power) / (1 - gamma), 1e-9);
}

// Claim A14 where it was never tried: the thesis has a pendulum with five actions.
TEST(Walking, Sarsa2QWithEqualTilesIsSarsaOnLeo) {
  const Registry registry = fullRegistry();
  Configuration one = walker(registry, "leo", "sarsa", {{"features.initial_high", "0"}});
  Configuration two = walker(registry, "leo", "sarsa-2q", {{"features.initial_high", "0"}});
  one.episodes = two.episodes = 60;
  const auto sarsa = makeLife(registry, one, 0, true), both = makeLife(registry, two, 0, true);
  for (const auto* life : {&sarsa, &both})
    while (!(**life)->finished()) (**life)->step();
  const auto &a = (*sarsa)->log().rows(), &b = (*both)->log().rows();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].steps, b[i].steps) << i;
    EXPECT_EQ(a[i].reward, b[i].reward) << i;
  }
}

TEST(Walking, MeasuresAreKeptInTheStoreAndFoundByTheLaboratory) {
  const Registry registry = fullRegistry();
  const auto plan = parsePlan(registry,
                              "lives = 3\n[base]\nenvironment = \"compass\"\nminutes = 10\n"
                              "pre-learning.minutes = 1\npre-learning.pool = 2\n[[condition]]\nname = \"Sarsa\"\n",
                              "plan.toml", {});
  ASSERT_TRUE(plan) << plan.error().message;
  const Folder folder;
  auto store = Store::create(folder.file("s"), *planToStore(registry, *plan));
  ASSERT_TRUE(store);
  ASSERT_TRUE(runPlan(registry, *plan, *store, {.jobs = 2}));
  const auto before = store->preLearned();
  ASSERT_TRUE(before);
  ASSERT_EQ(before->size(), 2u);
  EXPECT_EQ((*before)[0].steps, 1500) << "a minute of 25 steps a second";
  const auto evidence = readEvidence(registry, *store);
  ASSERT_TRUE(evidence) << evidence.error().message;
  for (const char* measure : {"distance", "net_footsteps", "falls_per_hour", "greedy_distance", "greedy_falls"}) {
    const auto values = valuesOf((*evidence)[0], measure);
    ASSERT_EQ(values.size(), 3u) << measure;
    for (const double v : values) EXPECT_TRUE(std::isfinite(v)) << measure;
  }
  for (const double v : valuesOf((*evidence)[0], "walks")) EXPECT_TRUE(v == 0.0 || v == 1.0) << v;
  for (const double v : valuesOf((*evidence)[0], "energy")) EXPECT_TRUE(std::isnan(v)) << "the compass has none";
  ASSERT_TRUE(exportCsv(*store, folder.file("csv"), "--csv"));
  EXPECT_TRUE(std::filesystem::exists(folder.file("csv") + "/measures.csv"));
  std::int64_t tests = 0;
  const auto measures = store->measures(0, 0);
  for (const StoredMeasure& m : *measures) tests += m.episode > 0 && m.name == "distance";
  EXPECT_EQ(tests, (*evidence)[0].lives.empty()
                       ? 0
                       : static_cast<std::int64_t>((*evidence)[0].record.episodes[0].size() / 10));
}

}  // namespace surefoot
