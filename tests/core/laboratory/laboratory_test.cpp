// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/laboratory.h"

#include <filesystem>
#include <fstream>
#include <map>

#include "core/findings/findings.h"
#include "tests/core/experiment/test_setup.h"
#include "tests/folder.h"

namespace surefoot {

namespace {

const char* const kPlan =
    "lives = 6\nreference = \"ε-greedy\"\n[base]\nminutes = 0.3\n"
    "[pre-learning]\nscenario = \"2\"\nuntil = 100\ncap = 200\npool = 3\n"
    "[[condition]]\nname = \"ε-greedy\"\n"
    "[[condition]]\nname = \"none\"\npre-learning = false\n"
    "[[condition]]\nname = \"TRL\"\npolicy = \"trl\"\nset.policy.threshold = 50\n";

class LaboratoryTest : public testing::Test {
 protected:
  Plan plan(std::optional<int> lives = {}) {
    auto made = parsePlan(registry, kPlan, "plan.toml", {.lives = lives, .seed = {}, .assignments = {}});
    EXPECT_TRUE(made) << made.error().message;
    return *made;
  }
  Store make(const std::string& name, int shard = 1, int shards = 1) {
    auto stored = planToStore(registry, plan());
    stored->shard = shard, stored->shards = shards;
    auto store = Store::create(folder.file(name), *stored);
    EXPECT_TRUE(store) << store.error().message;
    return std::move(*store);
  }
  LabResult run(Store& store, const LabOptions& options, std::optional<int> lives = {}) {
    const auto result = runPlan(registry, plan(lives), store, options);
    EXPECT_TRUE(result) << result.error().message;
    return *result;
  }

  Registry registry = fullRegistry();
  Folder folder;
};

}  // namespace

// Beside its episodes a life says how often it explored, and what the greedy policy does with what it has learned.
TEST_F(LaboratoryTest, ALifeKeepsItsShareOfExploringAndItsGreedyEnd) {
  Store store = make("measured");
  ASSERT_TRUE(run(store, {.jobs = 2}).complete());
  const auto evidence = readEvidence(registry, store);
  ASSERT_TRUE(evidence) << evidence.error().message;
  for (const Evidence& e : *evidence) {
    const double epsilon = e.configuration["parameters"].value("policy.epsilon", 0.0);
    const auto actions = 5.0;
    for (const double share : valuesOf(e, "exploring")) {
      EXPECT_GE(share, 0) << e.name();
      if (e.configuration.value("policy", "") == "epsilon-greedy") {
        EXPECT_NEAR(share, epsilon * (actions - 1) / actions, 0.25 * epsilon + 0.02) << e.name();
      }
    }
    for (const double falls : valuesOf(e, "final_falls")) EXPECT_TRUE(falls >= 0 && falls <= 1) << e.name();
    EXPECT_EQ(valuesOf(e, "final_reward").size(), e.lives.size());
  }
}

TEST_F(LaboratoryTest, TheSameContentForAnyNumberOfThreads) {
  std::optional<std::uint64_t> hash;
  for (const int jobs : {1, 2, 7}) {
    Store store = make(std::to_string(jobs));
    EXPECT_TRUE(run(store, {.jobs = jobs}).complete());
    const auto now = store.contentHash();
    ASSERT_TRUE(now);
    EXPECT_EQ(hash.value_or(*now), *now) << jobs;
    hash = *now;
  }
}

TEST_F(LaboratoryTest, AnotherConfigurationIsNamedByItsFirstDifference) {
  const auto ours = planToStore(registry, plan());
  auto theirs = *ours;
  auto json = nlohmann::json::parse(theirs.conditions[1].configuration);
  json["parameters"].erase("environment.damping");
  theirs.conditions[1].configuration = json.dump();
  const Status s = checkSamePlan(theirs, *ours, "results.sqlite");
  ASSERT_FALSE(s);
  EXPECT_NE(
      s.error().message.find("environment.damping of parameters of condition 2 (none) is nothing there and 0.08 here."),
      std::string::npos)
      << s.error().message;
}

// A policy that the program has learned since: no condition of the store has it.
TEST_F(LaboratoryTest, AParameterOfANewPolicyIsNoDifference) {
  const auto ours = planToStore(registry, plan());
  auto theirs = *ours;
  for (StoredCondition& c : theirs.conditions) {
    auto json = nlohmann::json::parse(c.configuration);
    ASSERT_EQ(json["parameters"].erase("policy.temperature"), 1u);
    c.configuration = json.dump();
  }
  const Status s = checkSamePlan(theirs, *ours, "results.sqlite");
  EXPECT_TRUE(s) << s.error().message;
  EXPECT_FALSE(checkSamePlan(*ours, theirs, "results.sqlite")) << "one that is gone is one";
}

TEST_F(LaboratoryTest, AStoredLifeIsTheLifeThatTrainWouldLive) {
  Store store = make("s");
  run(store, {.jobs = 2});
  const auto lives = store.lives();
  ASSERT_EQ(lives->size(), 18u);
  const StoredLife& stored = (*lives)[7];  // the second of "none"
  EXPECT_EQ(stored.condition, 1);
  EXPECT_EQ(stored.qFunction, -1);
  auto life = makeLife(registry, plan().conditions[1].configuration, 1, true);
  while (!(*life)->finished()) (*life)->step();
  EXPECT_EQ(stored.hash, (*life)->hash());
  EXPECT_EQ(stored.falls, (*life)->log().totals().falls);
  const auto episodes = store.episodes(1, 1);
  ASSERT_EQ(episodes->size(), (*life)->log().rows().size());
  EXPECT_EQ(episodes->back().transitions, (*life)->log().rows().back().steps);
}

TEST_F(LaboratoryTest, LivesOfOneQFunctionBeginWithIt) {
  Store store = make("s");
  run(store, {.jobs = 2});
  const auto pre = store.preLearned();
  ASSERT_EQ(pre->size(), 6u) << "three for each of two conditions";
  for (int q = 0; q < 3; ++q)
    EXPECT_EQ((*pre)[static_cast<std::size_t>(q)].hash, (*pre)[static_cast<std::size_t>(q) + 3].hash)
        << "both conditions share them";
  EXPECT_NE((*pre)[0].hash, (*pre)[1].hash);
  for (const StoredPreLearning& p : *pre) EXPECT_EQ(p.reached, p.averageReward >= 100);
  const auto lives = store.lives();
  for (const StoredLife& l : *lives) EXPECT_EQ(l.qFunction, l.condition == 1 ? -1 : l.life % 3);
}

TEST_F(LaboratoryTest, WhatIsMissingIsDoneWithTheSameContent) {
  Store whole = make("whole");
  run(whole, {.jobs = 2});
  {
    Store part = make("part");
    const std::atomic<bool> stop{true};
    EXPECT_EQ(run(part, {.jobs = 2, .interrupted = &stop}).livesThere, 0);
    EXPECT_EQ(run(part, {.jobs = 2, .shard = 2, .shards = 3}).livesThere, 6);
  }
  auto part = Store::openToWrite(folder.file("part"));
  ASSERT_TRUE(part) << part.error().message;
  EXPECT_TRUE(run(*part, {.jobs = 2}).complete());
  EXPECT_EQ(*part->contentHash(), *whole.contentHash());
}

TEST_F(LaboratoryTest, WhatIsInterruptedHasAsManyLivesOfEveryCondition) {
  std::string text = kPlan;
  text.replace(text.find("0.3"), 3, "30");  // long enough to be interrupted
  const auto plan = parsePlan(registry, text, "plan.toml", {.lives = {}, .seed = {}, .assignments = {}});
  ASSERT_TRUE(plan) << plan.error().message;
  auto store = Store::create(folder.file("s"), *planToStore(registry, *plan));
  ASSERT_TRUE(store) << store.error().message;
  std::atomic<bool> stop{false};
  const auto watch = [&](const LabProgress& p) { stop = p.work.livesDone >= 4; };
  ASSERT_TRUE(runPlan(registry, *plan, *store, {.jobs = 1, .interrupted = &stop, .progress = watch}));
  std::map<int, int> count;
  const auto lives = store->lives();
  ASSERT_GE(lives->size(), 4u);
  ASSERT_LT(lives->size(), 18u);
  for (const StoredLife& l : *lives) ++count[l.condition];
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(count[c], static_cast<double>(lives->size()) / 3, 1) << c;
}

TEST_F(LaboratoryTest, ShardsJoinedAreTheWhole) {
  Store whole = make("whole"), joined = make("joined");
  run(whole, {.jobs = 2});
  for (int shard = 1; shard <= 5; ++shard) {
    const std::string name = "part" + std::to_string(shard);
    {
      Store part = make(name, shard, 5);
      EXPECT_EQ(run(part, {.jobs = 1, .shard = shard, .shards = 5}).livesPlanned, shard <= 3 ? 4 : 3);
    }
    const auto part = Store::open(folder.file(name));
    const Status added = joined.add(*part);
    ASSERT_TRUE(added) << added.error().message;
    EXPECT_FALSE(joined.add(*part)) << "twice";
  }
  EXPECT_EQ(*joined.contentHash(), *whole.contentHash());
}

TEST_F(LaboratoryTest, MoreLivesKeepThoseThereAre) {
  Store store = make("s"), longer = make("l");
  run(store, {.jobs = 2});
  ASSERT_TRUE(longer.setLives(8));
  const LabResult r = run(longer, {.jobs = 2}, 8);
  EXPECT_EQ(r.livesThere, 24);
  const auto few = store.lives(), many = longer.lives();
  EXPECT_EQ((*few)[5].hash, (*many)[5].hash);
  EXPECT_EQ((*few)[6].hash, (*many)[8].hash) << "the first life of the second condition";
}

TEST_F(LaboratoryTest, OneProcessAtATimeWrites) {
  Store store = make("s");
  const auto second = Store::openToWrite(folder.file("s"));
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message.find("another process"), std::string::npos) << second.error().message;
  EXPECT_FALSE(Store::create(folder.file("s"), *planToStore(registry, plan())));
}

TEST_F(LaboratoryTest, WhatIsNoStoreIsRefused) {
  std::ofstream(folder.file("text")) << "This is a text and not a store, however long it may be; an SQLite file has a "
                                        "header of a hundred bytes, so let there be more than those.";
  for (const char* name : {"text", "absent", "."}) {
    EXPECT_FALSE(Store::open(folder.file(name))) << name;
    EXPECT_FALSE(Store::openToWrite(folder.file(name))) << name;
  }
  std::ofstream(folder.file("empty")).flush();
  EXPECT_TRUE(Store::missing(folder.file("empty"))) << "a run that was killed before it wrote";
  { make("damaged"); }
  std::filesystem::resize_file(folder.file("damaged"), 5000);
  const auto damaged = Store::open(folder.file("damaged"));
  EXPECT_TRUE(!damaged || !damaged->plan());
}

TEST_F(LaboratoryTest, FindingsCompareWithTheReference) {
  Store store = make("s");
  run(store, {.jobs = 2});
  const auto findings = findingsOf(registry, store);
  ASSERT_TRUE(findings) << findings.error().message;
  ASSERT_EQ(findings->conditions.size(), 3u);
  EXPECT_TRUE(findings->complete);
  const Finding &reference = findings->conditions[0], &none = findings->conditions[1], &trl = findings->conditions[2];
  EXPECT_FALSE(reference.comparison);
  ASSERT_TRUE(none.comparison && trl.comparison);
  EXPECT_FALSE(none.comparison->paired) << "nothing is shared with it";
  EXPECT_TRUE(trl.comparison->paired) << "the same Q-functions";
  EXPECT_EQ(reference.qFunctions, 3);
  EXPECT_TRUE(reference.betweenQFunctions);
  EXPECT_FALSE(none.betweenQFunctions);
  EXPECT_NEAR(none.comparison->change.value, 100 * (none.falls.value / reference.falls.value - 1), 1e-9);
  EXPECT_GE(none.comparison->holm, none.comparison->p());
  EXPECT_FALSE(reference.end) << "lives of 18 seconds never end";
  EXPECT_FALSE(reference.warnings.empty());
  EXPECT_EQ(findingsAsJson(*findings).dump(), findingsAsJson(*findingsOf(registry, store)).dump());
}

}  // namespace surefoot
