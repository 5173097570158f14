// SPDX-License-Identifier: GPL-3.0-or-later
// Lives in hand outlast a pause and an end, bit for bit.
#include "core/laboratory/kept_lives.h"

#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/files/whole_file.h"
#include "core/laboratory/laboratory.h"
#include "tests/core/experiment/test_setup.h"
#include "tests/folder.h"

namespace surefoot {

namespace {

namespace fs = std::filesystem;

class KeptLivesTest : public testing::Test {
 protected:
  Plan planOf(const std::string& text) {
    auto made = parsePlan(registry, text, "plan.toml", {});
    EXPECT_TRUE(made) << made.error().message;
    return *made;
  }
  Store make(const Plan& plan, const std::string& name) {
    auto store = Store::create(folder.file(name), *planToStore(registry, plan));
    EXPECT_TRUE(store) << store.error().message;
    return std::move(*store);
  }
  std::uint64_t hashOfWhole(const Plan& plan) {
    Store store = make(plan, "whole");
    const auto result = runPlan(registry, plan, store, {.jobs = 2});
    EXPECT_TRUE(result) << result.error().message;
    EXPECT_TRUE(result->complete());
    const std::uint64_t hash = *store.contentHash();
    fs::remove(folder.file("whole"));
    return hash;
  }
  /// Runs for some time, then is interrupted.
  LabResult runFor(const Plan& plan, Store& store, std::chrono::milliseconds time, int jobs) {
    std::atomic<bool> stop{false};
    std::jthread stopper([&](const std::stop_token& over) {
      for (auto t = std::chrono::milliseconds(0); t < time && !over.stop_requested(); t += std::chrono::milliseconds(2))
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
      stop = true;
    });
    const auto result = runPlan(registry, plan, store, {.jobs = jobs, .interrupted = &stop});
    EXPECT_TRUE(result) << result.error().message;
    EXPECT_TRUE(result->keeping) << result->keeping.error().message;
    return *result;
  }
  bool litter(const std::string& name) const { return fs::exists(folder.file(name + ".lives")); }

  Registry registry = fullRegistry();
  Folder folder;
};

const std::string kLong =
    "lives = 2\n[base]\nminutes = 25\n[pre-learning]\nscenario = \"2\"\nminutes = 15\npool = 2\n"
    "[[condition]]\nname = \"a\"\n[[condition]]\nname = \"b\"\npre-learning = false\npolicy = \"softmax\"\n";

}  // namespace

// The last life of a folder is over, and the folder goes, while another life is about to be written there.
TEST_F(KeptLivesTest, AFolderIsNotTakenAwayUnderALifeThatIsKept) {
  KeptLives kept(folder.file("s"));
  std::atomic<bool> over{false};
  std::thread dropping([&] {
    while (!over) kept.drop("life-b");
  });
  int failed = 0;
  for (int i = 0; i < 5000; ++i) {
    failed += !kept.keep("life-a", TensorFile{});
    kept.drop("life-a");
  }
  over = true;
  dropping.join();
  EXPECT_EQ(failed, 0);
}

TEST_F(KeptLivesTest, StoppedAgainAndAgainTheContentIsThatOfOneRun) {
  const std::string task = "lives = 2\n[[condition]]\nname = \"a\"\n";
  const std::vector<std::string> plans = {
      kLong,
      task + "minutes = 30\nagent = \"sarsa-2q\"\npolicy = \"trl\"\nset.policy.threshold = 50\n",
      task + "minutes = 30\nagent = \"q-learning\"\nset.features.memory = 4096\nset.shaping.rewards = \"all\"\n",
      task + "minutes = 30\nfeatures = \"radial-basis\"\nset.policy.epsilon_schedule = \"linear\"\n",
      task + "environment = \"compass\"\nminutes = 10\n",
      task + "environment = \"leo\"\nminutes = 3\n",
      task + "environment = \"mountain-car\"\nepisodes = 2000\n"};
  for (const std::string& text : plans) {
    const Plan plan = planOf(text);
    // A checkpoint of LEO takes half a second to write and to read.
    const int unit = plan.conditions[0].configuration.names.environment == "leo" ? 20 : 1;
    const std::uint64_t whole = hashOfWhole(plan);
    int rounds = 0, kept = 0;
    for (bool complete = false; !complete; ++rounds) {
      // Every time it is opened anew, as after an end of the program.
      auto store = rounds == 0 ? Result<Store>(make(plan, "s")) : Store::openToWrite(folder.file("s"));
      ASSERT_TRUE(store) << store.error().message;
      const auto time = std::chrono::milliseconds(unit * (10 + 15 * rounds));  // longer, so that it ends
      const LabResult result = runFor(plan, *store, time, 1 + rounds % 3);
      kept += result.livesKept;
      complete = result.complete();
      EXPECT_EQ(litter("s"), result.livesKept > 0);
    }
    EXPECT_GT(kept, 0) << "too short to be interrupted:\n" << text;
    EXPECT_FALSE(litter("s")) << text;
    EXPECT_EQ(*Store::open(folder.file("s"))->contentHash(), whole) << text;
    fs::remove(folder.file("s"));
  }
}

TEST_F(KeptLivesTest, PausedTheyStandStillAndGoOnInMemory) {
  // Long enough that the first look at them finds lives in hand.
  const Plan plan = planOf(
      "lives = 2\n[base]\nminutes = 100\n[[condition]]\nname = \"a\"\n[[condition]]\nname = \"b\"\npolicy = "
      "\"softmax\"\n");
  const std::uint64_t whole = hashOfWhole(plan);
  Store store = make(plan, "s");
  std::atomic<bool> paused{false};
  std::vector<std::int64_t> steps, falls;
  std::size_t last = 0;  // of the pause
  const auto watch = [&](const LabProgress& p) {
    steps.push_back(p.work.steps), falls.push_back(p.falls);
    if (steps.size() == 1) paused = true;
    // Three seconds and more, until a copy of every life in hand is on the disk: a long pause outlasts a power cut.
    if (paused && steps.size() >= 14 && (KeptLives::count(store.path()) > 0 || steps.size() > 200)) {
      EXPECT_GT(KeptLives::count(store.path()), 0);
      last = steps.size() - 1;
      paused = false;
    }
  };
  const auto result = runPlan(registry, plan, store, {.jobs = 2, .paused = &paused, .progress = watch});
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_GT(last, 12u);
  ASSERT_GT(steps.size(), last + 1);
  EXPECT_GT(steps[2], 0);
  EXPECT_EQ(steps[last - 1], steps[last]) << "stood still";
  EXPECT_GT(steps.back(), steps[last]);
  EXPECT_TRUE(std::is_sorted(falls.begin(), falls.end())) << "no fall is forgotten";
  std::int64_t stored = 0;
  const auto lives = store.lives();
  for (const StoredLife& l : *lives) stored += l.falls;
  EXPECT_EQ(falls.back(), stored) << "the same number as the store's";
  EXPECT_EQ(*store.contentHash(), whole);
  EXPECT_FALSE(litter("s"));
}

TEST_F(KeptLivesTest, ALongLifeIsKeptWhileItGoesOn) {
  const Plan plan = planOf(kLong);
  Store store = make(plan, "s");
  int most = 0;
  const auto watch = [&](const LabProgress&) { most = std::max(most, KeptLives::count(store.path())); };
  ASSERT_TRUE(runPlan(registry, plan, store, {.jobs = 1, .keepEvery = 0.01, .progress = watch}));
  EXPECT_GT(most, 0);
  EXPECT_FALSE(litter("s"));
}

TEST_F(KeptLivesTest, WhatDoesNotBelongOrIsDamagedIsNotTakenUp) {
  const Plan plan = planOf(kLong), other = planOf("seed = 2\n" + kLong);
  const std::uint64_t whole = hashOfWhole(plan);
  Store store = make(plan, "s");
  EXPECT_GT(runFor(plan, store, std::chrono::milliseconds(150), 2).livesKept, 0);
  const std::string kept = folder.file("s.lives");
  int damaged = 0;
  for (const auto& entry : fs::directory_iterator(kept)) {
    fs::resize_file(entry.path(), fs::file_size(entry.path()) / 2);
    ++damaged;
  }
  EXPECT_GT(damaged, 0);
  const std::string stale = kept + "/" + KeptLives::nameOf(other.conditions[1], 0) + ".safetensors";
  std::ofstream(stale) << "of another seed";
  std::ofstream(kept + "/notes.txt") << "mine";
  EXPECT_TRUE(runPlan(registry, plan, store, {.jobs = 2})->complete());
  EXPECT_EQ(*store.contentHash(), whole);
  EXPECT_FALSE(fs::exists(stale));
  EXPECT_TRUE(fs::exists(kept + "/notes.txt")) << "what is not ours stays";
}

TEST_F(KeptLivesTest, AStoreIsGoneOnWithWithoutItsPlan) {
  const Plan plan = planOf("paired = true\n" + kLong);
  const std::uint64_t whole = hashOfWhole(plan);
  {
    Store store = make(plan, "s");
    runFor(plan, store, std::chrono::milliseconds(200), 2);
  }
  auto store = Store::openToWrite(folder.file("s"));
  const auto again = planFromStore(registry, *store);
  ASSERT_TRUE(again) << again.error().message;
  ASSERT_TRUE(runPlan(registry, *again, *store, {.jobs = 2})->complete());
  EXPECT_EQ(*store->contentHash(), whole);
}

TEST_F(KeptLivesTest, EveryRecipeOfTheProgramComesBackFromItsStore) {
  for (const char* name :
       {"chapter-4/4.3", "chapter-4/4.4-4.9", "chapter-5/5.1", "chapter-6/6.2", "walker/walker-mismatch"}) {
    const auto plan = readPlan(registry, std::string(SUREFOOT_SOURCE) + "/resources/recipes/" + name + ".toml", {});
    ASSERT_TRUE(plan) << plan.error().message;
    const auto again = planFromStore(registry, make(*plan, std::filesystem::path(name).filename().string()));
    ASSERT_TRUE(again) << again.error().message;
    ASSERT_EQ(again->conditions.size(), plan->conditions.size());
    for (std::size_t i = 0; i < plan->conditions.size(); ++i) {
      EXPECT_EQ(again->conditions[i].configuration.seed, plan->conditions[i].configuration.seed);
      EXPECT_EQ(again->conditions[i].preLearning.has_value(), plan->conditions[i].preLearning.has_value());
    }
  }
}

TEST_F(KeptLivesTest, AStoreWhoseConditionsAreDamagedSaysWhy) {
  const Plan plan = planOf(kLong);
  auto stored = *planToStore(registry, plan);
  auto json = nlohmann::json::parse(stored.conditions[0].configuration);
  json["environment"] = "tightrope";
  stored.conditions[0].configuration = json.dump();
  auto store = Store::create(folder.file("odd"), stored);
  ASSERT_TRUE(store);
  const auto again = planFromStore(registry, *store);
  ASSERT_FALSE(again);
  EXPECT_NE(again.error().message.find("tightrope"), std::string::npos) << again.error().message;
}

TEST_F(KeptLivesTest, AShardIsPlannedAsItsPart) {
  StoredPlan plan = *planToStore(registry, planOf(kLong));
  EXPECT_EQ(livesPlanned(plan), 4);
  plan.shards = 3;
  for (const auto& [shard, lives] : {std::pair{1, 2}, {2, 1}, {3, 1}}) {
    plan.shard = shard;
    EXPECT_EQ(livesPlanned(plan), lives) << shard;
  }
}

}  // namespace surefoot
