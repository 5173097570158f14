// SPDX-License-Identifier: GPL-3.0-or-later
// Plans whose number of lives follows from what the lives show.
#include <atomic>

#include "core/findings/findings.h"
#include "core/laboratory/laboratory.h"
#include "tests/core/experiment/test_setup.h"
#include "tests/folder.h"

namespace surefoot {

namespace {

const std::string kCliff =
    "[base]\nenvironment = \"cliff\"\nfeatures = \"table\"\nepisodes = 60\nset.policy.epsilon = 0.1\n"
    "set.agent.step_size = 0.5\nset.agent.discount = 1\nset.agent.trace_decay = 0\n";
const std::string kDecided =
    "lives = \"decided\"\nreference = \"Sarsa\"\n[decided]\nat_least = 5\nat_most = 30\ngroup = 5\n" + kCliff +
    "[[condition]]\nname = \"Sarsa\"\nagent = \"sarsa\"\n[[condition]]\nname = \"Q-learning\"\nagent = "
    "\"q-learning\"\n[[condition]]\nname = \"again\"\nagent = \"sarsa\"\nset.policy.epsilon = 0.1001\n";
const std::string kSearch =
    "lives = 6\nreference = \"ε-greedy\"\n[search]\ncondition = \"Softmax\"\nset.policy.temperature = [0.1, 50]\n"
    "values = 6\nbudget = 60\nfresh = 7\n" +
    kCliff + "[[condition]]\nname = \"ε-greedy\"\n[[condition]]\nname = \"Softmax\"\npolicy = \"softmax\"\n";

class GrowingPlan : public testing::Test {
 protected:
  Plan planOf(std::string text, const PlanChanges& changes = {}) {
    if (text.find("policy = \"softmax\"") != std::string::npos)  // Softmax has no ε
      text.replace(text.find("set.policy.epsilon = 0.1\n"), 25, "");
    auto plan = parsePlan(registry, text, "p.toml", changes);
    EXPECT_TRUE(plan) << plan.error().message;
    return *plan;
  }
  Result<Store> storeOf(const Plan& plan, const std::string& name) {
    return Store::create(folder.file(name), *planToStore(registry, plan));
  }
  std::string refusal(const std::string& text) {
    const auto plan = parsePlan(registry, text, "p.toml", {});
    return plan ? "" : plan.error().message;
  }

  Registry registry = fullRegistry();
  Folder folder;
};

}  // namespace

TEST_F(GrowingPlan, EndsAtTheSamePlaceForAnyNumberOfThreadsAndHoweverOftenItStopped) {
  for (const std::string& text : {kDecided, kSearch}) {
    const Plan plan = planOf(text);
    std::vector<std::uint64_t> contents;
    for (const int jobs : {1, 3}) {
      auto store = storeOf(plan, std::to_string(jobs) + plan.conditions[1].name);
      ASSERT_TRUE(store) << store.error().message;
      const auto result = runPlan(registry, plan, *store, {.jobs = jobs});
      ASSERT_TRUE(result) << result.error().message;
      EXPECT_TRUE(result->complete());
      EXPECT_FALSE(result->found.empty());
      contents.push_back(*store->contentHash());
    }
    auto stopped = storeOf(plan, "stopped" + plan.conditions[1].name);
    for (int i = 0; i < 200; ++i) {  // stopped again and again after a few lives
      std::atomic<bool> stop{false};
      LabOptions options{.jobs = 2, .interrupted = &stop};
      int looks = 0;
      options.progress = [&](const LabProgress&) { stop = ++looks > 1; };
      const auto again = planFromStore(registry, *stopped);
      ASSERT_TRUE(again) << again.error().message;
      const auto result = runPlan(registry, *again, *stopped, options);
      ASSERT_TRUE(result) << result.error().message;
      if (result->complete() && !result->found.empty()) break;
    }
    contents.push_back(*stopped->contentHash());
    EXPECT_EQ(contents[0], contents[1]);
    EXPECT_EQ(contents[0], contents[2]);
    std::filesystem::remove(folder.file("1" + plan.conditions[1].name));
  }
}

TEST_F(GrowingPlan, WhatIsClearStopsEarlyAndTheReferenceGoesOnForTheRest) {
  const Plan plan = planOf(kDecided);
  EXPECT_EQ(plan.lives, 5);
  auto store = storeOf(plan, "r");
  const auto result = runPlan(registry, plan, *store, {.jobs = 2});
  ASSERT_TRUE(result) << result.error().message;
  const auto stored = *store->plan();
  EXPECT_LT(stored.conditions[1].lives, stored.conditions[2].lives) << "Q-learning falls far more often";
  EXPECT_EQ(stored.conditions[0].lives, stored.conditions[2].lives);
  EXPECT_NE(result->found[0].find("Q-learning against Sarsa: more after "), std::string::npos) << result->found[0];
  const auto findings = findingsOf(registry, *store);
  ASSERT_TRUE(findings);
  EXPECT_EQ(findings->found, result->found);
  EXPECT_NE(findingsAsTable(*findings).find("decided by what they showed"), std::string::npos);
}

TEST_F(GrowingPlan, ASearchHalvesItsCandidatesAndReportsFromFreshLives) {
  const Plan plan = planOf(kSearch);
  EXPECT_TRUE(plan.paired) << "common seeds";
  ASSERT_EQ(plan.conditions.size(), 7u);
  auto store = storeOf(plan, "s");
  const auto result = runPlan(registry, plan, *store, {.jobs = 2});
  ASSERT_TRUE(result) << result.error().message;
  std::vector<int> lives;
  for (const StoredCondition& c : store->plan()->conditions) lives.push_back(c.lives);
  const std::vector<int> rounds = plan.growth.search->rounds();
  ASSERT_EQ(rounds.size(), 3u);
  EXPECT_EQ(lives[0], rounds.back() + 7) << "the reference";
  std::vector<int> candidates(lives.begin() + 1, lives.end());
  std::sort(candidates.begin(), candidates.end());
  EXPECT_EQ(candidates, (std::vector{rounds[0], rounds[0], rounds[0], rounds[1], rounds[2], rounds[2] + 7}));
  EXPECT_NE(result->found[0].find("in 7 others against ε-greedy"), std::string::npos) << result->found[0];
}

TEST_F(GrowingPlan, ASearchGoesInLogarithmicStepsOnEitherSideOfZero) {
  PlanSearch search;
  search.low = 10, search.high = 1000, search.values = 3;
  EXPECT_EQ(search.valuesToTry(), (std::vector<std::string>{"10", "100", "1e+03"}));
  search.low = -1000, search.high = -10;
  EXPECT_EQ(search.valuesToTry(), (std::vector<std::string>{"-1e+03", "-100", "-10"}));
}

TEST_F(GrowingPlan, WhatIsWrongIsNamed) {
  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_NE(refusal(replaced(kDecided, "at_least = 5", "at_least = 2")).find("at least 5"), std::string::npos);
  EXPECT_NE(refusal(replaced(kDecided, "group = 5", "gruop = 5")).find("did you mean group"), std::string::npos);
  EXPECT_NE(refusal(replaced(kDecided, "lives = \"decided\"", "lives = 5")).find("goes with lives"), std::string::npos);
  EXPECT_NE(refusal(replaced(kSearch, "\"Softmax\"\nset", "\"Sotfmax\"\nset")).find("Sotfmax"), std::string::npos);
  EXPECT_NE(refusal(replaced(kSearch, "[0.1, 50]", "[0, 50]")).find("logarithmic"), std::string::npos);
  EXPECT_NE(refusal(replaced(kSearch, "[0.1, 50]", "[-1, 50]")).find("logarithmic"), std::string::npos);
  EXPECT_NE(refusal(replaced(kSearch, "[0.1, 50]", "0.1")).find("[low, high]"), std::string::npos);
  EXPECT_NE(refusal(replaced(kSearch, "values = 6", "values = 1")).find("values from 2 on"), std::string::npos);

  Plan plan = planOf(kDecided);
  plan.growth.decided->measure = "fals";
  auto store = storeOf(plan, "w");
  const auto result = runPlan(registry, plan, *store, {});
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().message.find("fals"), std::string::npos) << result.error().message;
  EXPECT_EQ(store->lives()->size(), 0u) << "before a life is lived";
}

TEST(PlanGrowthLevels, AreSpentUpAndBeginSmall) {
  const DecidedLives d{.atLeast = 20, .atMost = 100, .group = 20, .level = 0.05};
  EXPECT_EQ(d.looks(), (std::vector{20, 40, 60, 80, 100}));
  double sum = 0;
  for (const double level : d.levels()) sum += level;
  EXPECT_NEAR(sum, 0.05, 1e-12);
  EXPECT_NEAR(d.levels()[0], 0.05 * std::log(1 + (std::exp(1.0) - 1) * 0.2), 1e-12);
}

TEST(PlanGrowthLevels, ComeBackFromTheStoreAsTheyWere) {
  PlanGrowth g{.decided = DecidedLives{.measure = "falls_6_min"}, .search = {}};
  EXPECT_EQ(growthAsJson(*growthFromJson(growthAsJson(g))), growthAsJson(g));
  g = {.decided = {},
       .search = PlanSearch{.condition = "a", .key = "b", .low = 1, .high = 2, .candidates = {"x", "y"}}};
  EXPECT_EQ(growthAsJson(*growthFromJson(growthAsJson(g))), growthAsJson(g));
  for (const char* odd : {"{}", "[]", "3", R"({"decided": 3})", R"({"search": {"values": -1}})"})
    EXPECT_FALSE(growthFromJson(nlohmann::json::parse(odd))) << odd;
}

}  // namespace surefoot
