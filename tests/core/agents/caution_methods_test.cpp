// SPDX-License-Identifier: GPL-3.0-or-later
// Calibration of the risk, the falls budget, the guardian, and files that know nothing of risk.
#include "core/agents/falls_budget.h"
#include "core/calibration.h"
#include "core/plans/plan.h"
#include "core/saved/carry_over.h"
#include "core/saved/checkpoint.h"
#include "core/saved/q_file.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

std::unique_ptr<Life> lived(const Registry& registry, const Configuration& c) {
  auto life = makeLife(registry, c, 0, true);
  EXPECT_TRUE(life) << (life ? "" : life.error().message);
  while (!(*life)->finished()) (*life)->step();
  return std::move(*life);
}

Configuration configured(const Registry& registry, const Names& names, const std::vector<Assignment>& assignments,
                         int episodes) {
  auto c = configure(registry, names, assignments);
  EXPECT_TRUE(c) << (c ? "" : c.error().message);
  c->episodes = episodes;
  return *c;
}

/// A Q-function as a file, read back.
std::shared_ptr<const TensorFile> fileOf(const Life& life, const Configuration& c) {
  return std::make_shared<const TensorFile>(qFileOf(life, c));
}

}  // namespace

TEST(Calibration, BehindATimeLimitCountsWhatIsExpectedThere) {
  Calibration c(0.5);
  for (const double said : {0.1, 0.3}) c.say(said);
  c.end(0.4);  // 0.4 for the last action, 0.2 for the one before
  EXPECT_NEAR(c.report().all.fell, 0.3, 1e-6);
  EXPECT_NEAR(c.report().all.said, 0.2, 1e-6);
}

TEST(Calibration, CountsAnActionByWhatCameOfIt) {
  Calibration c(0.5);
  for (const double said : {0.1, 0.2, 0.9}) c.say(said);
  EXPECT_EQ(c.report().all.count, 0) << "nothing has come yet";
  c.end(1.0);  // 1, 0.5 and 0.25, the last action first
  for (const double said : {0.0, 0.3}) c.say(said);
  c.end(0.0);
  const Calibration::Report report = c.report();
  EXPECT_EQ(report.all.count, 5);
  EXPECT_NEAR(report.all.said, 1.5 / 5, 1e-7);
  EXPECT_NEAR(report.all.fell, 1.75 / 5, 1e-7);
  // 0.0 → 0; 0.1 → 0.25; 0.2 and 0.3 → 0.5 and 0; 0.9 → 1.
  ASSERT_EQ(report.bins.size(), 4u);
  EXPECT_EQ(report.bins[2].count, 2);
  EXPECT_NEAR(report.bins[2].fell, 0.25, 1e-7);
  EXPECT_NEAR(report.error(), (0.0 + 0.15 + 2 * 0.0 + 0.1) / 5, 1e-7);
}

// Three episodes of two actions, −0.2, 0.4 and 0.2 apart in sum: 1.96·√(0.04 + 0.16 + 0.04)/6.
TEST(Calibration, TellsWhatChanceWouldMake) {
  Calibration c(1.0);
  for (const auto& [said, fell] : {std::pair{0.9, true}, {0.2, false}, {0.1, false}}) {
    c.say(said), c.say(said);
    c.end(fell);
  }
  const Calibration::Report report = c.report();
  EXPECT_NEAR(report.halfWidth, 1.96 * std::sqrt(0.24) / 6, 1e-6);
  EXPECT_NEAR(report.all.said - report.all.fell, 0.4 / 6, 1e-6);
  EXPECT_EQ(report.verdict(), Calibration::Verdict::Holds);
  for (int i = 0; i < 100; ++i) c.say(0.5), c.end(1.0);
  EXPECT_EQ(c.report().verdict(), Calibration::Verdict::Errs);
}

TEST(Calibration, IsUnclearWhereFewEpisodesFell) {
  Calibration c(1.0);
  for (int episode = 0; episode < 40; ++episode) {
    for (int i = 0; i < 10; ++i) c.say(0.005);
    c.end(episode == 0 ? 1.0 : 0.0);
  }
  const Calibration::Report report = c.report();
  EXPECT_NEAR(report.all.fell, 0.025, 1e-6);
  EXPECT_EQ(report.verdict(), Calibration::Verdict::Unclear) << report.halfWidth;
}

TEST(Calibration, KeepsTheLastActionsOnly) {
  Calibration c(1.0);
  c.say(0.7);
  c.end(1.0);
  for (std::size_t i = 0; i < Calibration::kSteps; ++i) c.say(0.5);
  EXPECT_EQ(c.report().all.count, 0) << "an episode as long as the memory";
  c.end(0.0);
  EXPECT_EQ(c.report().all.count, static_cast<std::int64_t>(Calibration::kSteps));
  EXPECT_EQ(c.report().all.fell, 0.0);
  c.say(0.5), c.say(0.5);
  c.abandon();
  EXPECT_EQ(c.report().all.count, static_cast<std::int64_t>(Calibration::kSteps) - 2);
}

// What is said of a policy that does not change comes true: on the cliff, walked at random.
TEST(Calibration, HoldsWhereThePolicyStaysAsItIs) {
  const Registry registry = fullRegistry();
  const Configuration c = configured(registry, {.environment = "chain", .features = "table"},
                                     {{"risk.learn", "on"}, {"risk.step_size", "0.02"}, {"policy.epsilon", "1"}}, 4000);
  const auto life = lived(registry, c);
  const Calibration::Report report = life->agent().calibration()->report();
  EXPECT_GT(report.all.fell, 0.2);
  EXPECT_LT(report.all.fell, 0.8);
  EXPECT_NEAR(report.all.said, report.all.fell, 0.03);
  EXPECT_LT(report.error(), 0.05);
}

// d = 0.25, η = 8: a fall in the first episode makes 6, none in the second 4, one in the third 10.
TEST(FallsBudget, FindsItsPrice) {
  const Registry registry = fullRegistry();
  Configuration c = configured(
      registry, {}, {{"agent.budget", "on"}, {"agent.falls_budget", "0.25"}, {"agent.budget_rate", "8"}}, 60);
  const auto life = lived(registry, c);
  double price = 0.0;
  for (const EpisodeRow& row : life->log().rows())
    price = std::max(0.0, price + 8 * (static_cast<double>(row.falls) - 0.25));
  EXPECT_EQ(life->agent().priceOfFall(), price);
  EXPECT_GT(price, 50);
}

TEST(FallsBudget, WithARateOfZeroItChangesNoBit) {
  const Registry registry = fullRegistry();
  for (const char* agent : {"sarsa", "sarsa-2q"}) {
    const auto with = lived(
        registry, configured(registry, {.agent = agent}, {{"agent.budget", "on"}, {"agent.budget_rate", "0"}}, 100));
    const auto without = lived(registry, configured(registry, {.agent = agent}, {}, 100));
    EXPECT_EQ(with->hash(), without->hash()) << agent;
  }
}

// A price that is reached at once and stays is a lower fall reward; the log keeps the environment's own.
TEST(FallsBudget, IsALargerPenaltyAndTheLogKeepsTheReward) {
  const Registry registry = fullRegistry();
  const auto with =
      lived(registry, configured(registry, {}, {{"agent.budget", "on"}, {"agent.budget_rate", "30"}}, 300));
  const auto without = lived(registry, configured(registry, {}, {}, 300));
  EXPECT_LT(with->log().totals().falls, without->log().totals().falls);
  for (const EpisodeRow& row : with->log().rows()) {
    EXPECT_TRUE(row.falls == 0 || row.reward == -100) << row.reward;
  }
}

TEST(Guardian, ActsWhereTheRiskIsHighAndIsCounted) {
  const Registry registry = fullRegistry();
  const std::vector<Assignment> learned = {{"risk.learn", "on"}, {"risk.memory", "65536"}, {"risk.discount", "1"}};
  const auto with = [&](const char* limit) {
    auto assignments = learned;
    assignments.push_back({"policy.guardian", "hand-made"});
    assignments.push_back({"policy.guardian_limit", limit});
    return lived(registry, configured(registry, {.environment = "leo"}, assignments, 100));
  };
  const auto without = lived(registry, configured(registry, {.environment = "leo"}, learned, 100));
  EXPECT_EQ(without->agent().guarded(), 0);
  const auto guarded = with("0.01");
  EXPECT_GT(guarded->agent().guarded(), guarded->steps() / 20);
  EXPECT_LT(guarded->agent().guarded(), guarded->steps());
  EXPECT_LT(guarded->log().totals().falls * without->steps(), without->log().totals().falls * guarded->steps());
  EXPECT_EQ(with("1")->hash(), without->hash()) << "no risk is above 1";
}

TEST(Guardian, IsRefusedWhereThereIsNoControllerOrNoRisk) {
  const Registry registry = fullRegistry();
  for (const auto& [names, assignments, words] :
       {std::tuple{Names{}, std::vector<Assignment>{{"risk.learn", "on"}}, "no hand-made controller"},
        {Names{.environment = "leo"}, std::vector<Assignment>{}, "risk.learn = on"}}) {
    auto c = configured(registry, names, assignments, 1);
    ASSERT_TRUE(c.parameters.set("policy.guardian", std::string_view("hand-made")));
    const auto refused = makeLife(registry, c, 0, false);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find(words), std::string::npos) << refused.error().message;
  }
}

// The action nearest to what the controller wants does nearly what the controller does.
TEST(Guardian, TheNearestActionsWalkAsTheControllerDoes) {
  const Registry registry = fullRegistry();
  const auto walked = [&](bool nearest) {
    auto leo = makeEnvironment(registry, configured(registry, {.environment = "leo"}, {}, 1));
    Random random(1);
    (*leo)->reset(random);
    for (Outcome o; o.ending == Ending::None;) o = (*leo)->step(nearest ? (*leo)->handMadeAction() : kHandMade);
    return (*leo)->measures()[0];
  };
  EXPECT_GT(walked(false), 5.0);
  EXPECT_GT(walked(true), 2.0);
}

TEST(Risk, AFileWithoutItBeginsAtTheInitialRiskAndSaysSo) {
  const Registry registry = fullRegistry();
  const Configuration without = configured(registry, {}, {}, 40);
  const auto file = fileOf(*lived(registry, without), without);
  Configuration with = configured(registry, {}, {{"risk.learn", "on"}, {"risk.initial", "0.25"}}, 1);
  EXPECT_NE(riskNote(*file, with).find("begins at 0.25"), std::string::npos);
  EXPECT_EQ(riskNote(*file, without), "");
  beginWith(with, file);
  const auto life = makeLife(registry, with, 0, false);
  ASSERT_TRUE(life) << life.error().message;
  const std::vector<double> upright = {0.0, 0.0, 0.0};
  std::vector<double> risk(5), q(5), before(5);
  (*life)->agent().values().evaluate(upright, Layer::Risk, risk);
  for (const double r : risk) EXPECT_NEAR(r, 0.25, 1e-12);
}

TEST(Risk, AFileWithItIsReadWhereNoneIsLearned) {
  const Registry registry = fullRegistry();
  const Configuration with = configured(registry, {}, {{"risk.learn", "on"}}, 40);
  const auto first = lived(registry, with);
  const auto file = fileOf(*first, with);
  EXPECT_EQ(riskNote(*file, with), "");
  for (const char* learn : {"off", "on"}) {
    Configuration next = configured(registry, {}, {{"risk.learn", learn}}, 1);
    beginWith(next, file);
    const auto life = makeLife(registry, next, 0, false);
    ASSERT_TRUE(life) << life.error().message;
    EXPECT_EQ((*life)->agent().values().tables(), first->agent().values().tables()) << "risk " << learn;
  }
}

// Into other tiles the risk goes along: else a careful robot would be bold without a word.
TEST(Risk, IsCarriedOverIntoOtherTiles) {
  const Registry registry = fullRegistry();
  const std::vector<Assignment> learned = {{"risk.learn", "on"}, {"policy.epsilon", "1"}};
  const auto from = lived(registry, configured(registry, {.environment = "chain"}, learned, 300));
  const auto to = makeLife(registry, configured(registry, {.environment = "chain"}, learned, 1), 0, false);
  ASSERT_TRUE(to) << to.error().message;
  const Task& task = from->environment().task();
  carryOver(from->agent().values(), const_cast<Agent&>((*to)->agent()), task);
  double highest = 0.0;
  std::vector<double> before(task.actions.size()), after(task.actions.size());
  for (double s = task.state[0].low; s <= task.state[0].high; s += 1.0) {
    const std::vector<double> state = {s};
    from->agent().values().evaluate(state, Layer::Risk, before);
    (*to)->agent().values().evaluate(state, Layer::Risk, after);
    for (std::size_t a = 0; a < before.size(); ++a) {
      highest = std::max(highest, before[a]);
      EXPECT_NEAR(after[a], before[a], 0.1) << "state " << s;
    }
  }
  EXPECT_GT(highest, 0.3);
}

// A lesson with risk beside it has the same values, so that conditions begin with the same Q-functions.
TEST(Risk, ChangesNoLesson) {
  const Registry registry = fullRegistry();
  const auto plan = parsePlan(registry,
                              "[base]\nminutes = 1\n[pre-learning]\nscenario = \"2\"\nminutes = 0.5\n"
                              "[[condition]]\nname = \"none\"\n"
                              "[[condition]]\nname = \"filter\"\nset.risk.learn = \"on\"\nset.risk.step_size = 0.2\n"
                              "set.policy.risk = \"filter\"\n",
                              "plan.toml", {});
  ASSERT_TRUE(plan) << plan.error().message;
  const auto &none = *plan->conditions[0].preLearning, &filter = *plan->conditions[1].preLearning;
  EXPECT_EQ(none.configuration.seed, filter.configuration.seed);
  EXPECT_NE(none.text, filter.text) << "one of them knows ρ";
  EXPECT_EQ(filter.configuration.parameters.get("policy.risk"), 0) << "the lesson is bold";
  EXPECT_EQ(filter.configuration.parameters.get("risk.step_size"), 0.2);
  EXPECT_EQ(lived(registry, none.configuration)->hash(), lived(registry, filter.configuration)->hash());
}

TEST(Risk, ALifeWithEveryOptionGoesOnFromACheckpoint) {
  const Registry registry = fullRegistry();
  Configuration c = configured(registry, {.environment = "leo", .agent = "sarsa-2q"},
                               {{"risk.learn", "on"},
                                {"risk.memory", "65536"},
                                {"agent.budget", "on"},
                                {"policy.risk", "explore"},
                                {"policy.guardian", "hand-made"}},
                               60);
  auto whole = makeLife(registry, c, 0, false), first = makeLife(registry, c, 0, false);
  ASSERT_TRUE(whole && first);
  (*first)->keepInputs();
  for (int i = 0; i < 701; ++i) (*first)->step();
  const TensorFile file = checkpointOf(**first, c, true);
  auto resumed = resume(registry, std::make_shared<const TensorFile>(file), {});
  ASSERT_TRUE(resumed) << resumed.error().message;
  while (!(*whole)->finished()) (*whole)->step();
  Life& rest = *resumed->life;
  while (!rest.finished()) rest.step();
  EXPECT_EQ(rest.hash(), (*whole)->hash());
  EXPECT_EQ(rest.agent().guarded(), (*whole)->agent().guarded());
  EXPECT_EQ(rest.agent().priceOfFall(), (*whole)->agent().priceOfFall());
  const auto a = rest.agent().calibration()->report(), b = (*whole)->agent().calibration()->report();
  EXPECT_EQ(a.all.said, b.all.said);
  EXPECT_EQ(a.all.fell, b.all.fell);
}

}  // namespace surefoot
