// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/robustness/robustness.h"

#include "core/policies/greedy.h"
#include "core/robustness/robustness_text.h"
#include "core/robustness/trial.h"
#include "core/saved/q_file.h"
#include "core/signals/rollout.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

const Registry& robots() {
  static const Registry all = fullRegistry();
  return all;
}

/// Reaches its goal ten steps after every start; a push above 0.5 N s makes it fall two steps later, one above 1 N s
/// tears it apart at once.
class Stander final : public Environment {
 public:
  Stander() {
    task_.state = {{.key = "steps", .low = 0, .high = 10}};
    task_.actions = {0.0};
    task_.stepTime = 0.1;
    task_.goalReward = 1.0;
  }
  void declare(Fields&) override {}
  const Task& task() const override { return task_; }
  void reset(Random&) override { state_ = {0}, fallsIn_ = -1, torn_ = false, ++episodes; }
  Outcome step(Action) override {
    state_[0] += 1;
    ++steps;
    if (torn_) {
      ++cutOffs_.all;
      return {.ending = Ending::Truncated};
    }
    if (fallsIn_ >= 0 && fallsIn_-- == 1) return {.ending = Ending::Terminal, .event = Event::Fall};
    if (state_[0] == 10) return {.ending = Ending::Terminal, .event = Event::Success};
    return {};
  }
  bool push(double impulse) override {
    pushedAt = steps;
    if (impulse > 0.5) fallsIn_ = 2;
    torn_ = impulse > 1;
    return true;
  }
  std::span<const double> state() const override { return state_; }
  CutOffs cutOffs() const override { return cutOffs_; }
  std::vector<double> pose() const override { return {}; }
  void draw(std::span<const double>, Scene&) const override {}
  std::vector<ReadOut> readOuts(std::span<const double>) const override { return {}; }

  std::int64_t steps = 0, episodes = 0, pushedAt = -1;

 private:
  Task task_;
  std::array<double, 1> state_{};
  int fallsIn_ = -1;
  bool torn_ = false;
  CutOffs cutOffs_;
};

/// One action, worth nothing.
class Nothing final : public ActionValueFunction {
 public:
  int actions() const override { return 1; }
  void evaluate(std::span<const double>, Layer, std::span<double> q) const override { q[0] = 0; }
  double visits(std::span<const double>) const override { return 0; }
  double familiarity(std::span<const double>) const override { return 0; }
  void average(std::span<const Eligibility>, std::span<const double>, std::span<double>) const override {}
  std::vector<std::vector<double>> tables() const override { return {}; }
  std::vector<MemoryUse> memoryUse() const override { return {}; }
  std::size_t bytes() const override { return 0; }
  std::unique_ptr<ActionValueFunction> clone() const override { return std::make_unique<Nothing>(); }
  void assign(const ActionValueFunction&) override {}
};

TriedFunction learnt(int episodes, const std::vector<Assignment>& assignments = {}, const Names& names = {}) {
  auto c = configure(robots(), names, assignments);
  EXPECT_TRUE(c) << (c ? "" : c.error().message);
  c->episodes = episodes;
  const auto life = lifeOf(robots(), *c);
  while (!life->finished()) life->step();
  auto tried =
      makeTried(robots(), "life " + std::to_string(episodes), std::make_shared<const TensorFile>(qFileOf(*life, *c)));
  EXPECT_TRUE(tried) << (tried ? "" : tried.error().message);
  return std::move(*tried);
}

Robustness triedOut(const std::vector<const TriedFunction*>& functions, const RobustnessQuestion& question, int jobs) {
  const auto plan = makeRobustnessPlan(robots(), functions, question);
  EXPECT_TRUE(plan) << (plan ? "" : plan.error().message);
  auto robustness = tryOut(robots(), *plan, functions, jobs, nullptr);
  EXPECT_TRUE(robustness) << (robustness ? "" : robustness.error().message);
  return std::move(*robustness);
}

void expectQuestionRefused(const std::vector<const TriedFunction*>& functions, const RobustnessQuestion& question,
                           const std::string& words) {
  const auto plan = makeRobustnessPlan(robots(), functions, question);
  ASSERT_FALSE(plan) << words;
  EXPECT_NE(plan.error().message.find(words), std::string::npos) << plan.error().message;
}

}  // namespace

// Pushed 25 steps after its beginning it is in the fifth step of its third episode.
TEST(Trial, IsPushedInTheEpisodeInHandAndFollowedToItsEnd) {
  const auto tryOn = [](Stander& stander, double impulse, std::int64_t after) {
    const auto end =
        tryOnce(stander, Nothing(), Greedy(), {.earliest = 25, .latest = 25, .after = after, .impulse = impulse});
    EXPECT_TRUE(end);
    return *end;
  };
  Stander light, hard, shortly, torn, alone;
  EXPECT_EQ(tryOn(light, 0.4, 100), TrialEnd::Succeeded);
  EXPECT_EQ(light.pushedAt, 25);
  EXPECT_EQ(light.episodes, 3);
  EXPECT_EQ(light.steps, 30);
  EXPECT_EQ(tryOn(hard, 0.6, 100), TrialEnd::Fell);
  EXPECT_EQ(hard.steps, 27) << "two steps after the push";
  EXPECT_EQ(tryOn(shortly, 0.6, 1), TrialEnd::Held) << "the time was up before it fell";
  EXPECT_EQ(tryOn(torn, 2, 100), TrialEnd::FlewApart);
  EXPECT_EQ(tryOn(alone, 0, 100), TrialEnd::Succeeded);
  EXPECT_EQ(alone.pushedAt, -1);
}

TEST(Trial, DrawsItsMomentFromSeedAndNumberAlone) {
  std::vector<int> counts(11, 0);
  for (std::uint64_t n = 0; n < 11'000; ++n) {
    const Trial trial{.seed = 3, .number = n, .earliest = 5, .latest = 15, .after = 1};
    ASSERT_GE(momentOf(trial), 5);
    ASSERT_LE(momentOf(trial), 15);
    Trial other = trial;
    other.impulse = 1.0, other.after = 77;
    EXPECT_EQ(momentOf(trial), momentOf(other));
    ++counts[static_cast<std::size_t>(momentOf(trial) - 5)];
  }
  for (const int count : counts) EXPECT_NEAR(count, 1000, 5 * 30) << "five standard errors";
}

// Trial 0 begins and is pushed as a roll-out of the same seed.
TEST(Trial, IsTheRollOutOfItsSeed) {
  const TriedFunction f = learnt(200);
  const auto environment = makeEnvironment(robots(), f.configuration);
  int falls = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Trial trial{.seed = seed, .earliest = 100, .latest = 400, .after = 2000, .impulse = 0.1};
    const auto end = tryOnce(**environment, f.values(), Greedy(), trial);
    ASSERT_TRUE(end);
    const auto moment = static_cast<std::size_t>(momentOf(trial));
    const Rollout r = rollOut(**environment, f.values(), Greedy(),
                              {.seed = seed, .steps = 2400, .pushes = {{static_cast<double>(moment) * 0.005, 0.1}}});
    const auto &fall = *r.table.column("fall"), &ended = *r.table.column("end");
    std::size_t row = moment;
    while (row + 1 < ended.size() && ended[row] == 0.0) ++row;
    EXPECT_EQ(*end == TrialEnd::Fell, fall[row] != 0.0) << seed;
    falls += *end == TrialEnd::Fell;
  }
  EXPECT_GT(falls, 0);
  EXPECT_LT(falls, 20);
}

TEST(Robustness, IsTheSameForAnyNumberOfThreads) {
  const TriedFunction a = learnt(300), b = learnt(100);
  const RobustnessQuestion question{.push = "0..0.2:3", .scenario = "all", .starts = "25"};
  const Robustness one = triedOut({&a, &b}, question, 1), three = triedOut({&a, &b}, question, 3);
  ASSERT_EQ(one.tallies.size(), 2u * 7 * 3);
  EXPECT_EQ(robustnessAsJson(one), robustnessAsJson(three));
  for (const Tally& tally : one.tallies) EXPECT_EQ(tally.trials, 25);
}

TEST(Robustness, TellsTwoApartOnlyWhereTheyDiffer) {
  const TriedFunction good = learnt(600), same = learnt(600), bad = learnt(1);
  const RobustnessQuestion question{.push = "0;0.05;5", .starts = "40"};
  const Robustness alike = triedOut({&good, &same}, question, 2), different = triedOut({&good, &bad}, question, 2);
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_EQ(alike.at(0, 0, p).falls, alike.at(1, 0, p).falls) << "pairs of the same starts";
    EXPECT_FALSE(alike.differ(0, p));
    EXPECT_EQ(alike.at(0, 0, p).falls, different.at(0, 0, p).falls) << "whatever stands beside it";
  }
  EXPECT_TRUE(different.differ(0, 0));
  EXPECT_FALSE(different.differ(0, 2)) << "5 N s throw both over";
  EXPECT_EQ(different.at(0, 0, 2).falls, 40);
  EXPECT_EQ(different.at(1, 0, 2).falls, 40);
}

TEST(Robustness, ItsModelsAreScenariosTimesValues) {
  const TriedFunction f = learnt(1);
  const auto plan = makeRobustnessPlan(
      robots(), {&f}, {.scenario = "1;4", .settings = {"environment.friction=0;0.05", "environment.pole_mass=1..2:3"}});
  ASSERT_TRUE(plan) << plan.error().message;
  ASSERT_EQ(plan->models.size(), 2u * 2 * 3);
  EXPECT_EQ(plan->keys, (std::vector<std::string>{"environment.friction", "environment.pole_mass"}));
  const TriedModel& model = plan->models[4];
  EXPECT_EQ(model.title, "1 Realistic, friction = 0.05 N m, pole_mass = 1.5 kg");
  const Configuration c = plan->modelled(model);
  EXPECT_EQ(c.parameters.get("environment.damping"), 0.088) << "the scenario's";
  EXPECT_EQ(c.parameters.get("environment.friction"), 0.05) << "not the scenario's 0.03";
  EXPECT_EQ(c.parameters.get("environment.pole_mass"), 1.5);
}

TEST(Robustness, ATaskWithoutABodyHasSuccesses) {
  const TriedFunction f = learnt(200, {}, {.environment = "mountain-car"});
  const Robustness r = triedOut({&f}, {.starts = "5"}, 2);
  EXPECT_EQ(r.tallies.size(), 1u);
  EXPECT_EQ(r.tallies[0].trials, 5);
  expectQuestionRefused({&f}, {.push = "0;1"}, "no body to push");
  expectQuestionRefused({&f}, {.scenario = "all"}, "has no scenarios");
}

TEST(Robustness, RefusesWhatCannotBeAsked) {
  const TriedFunction f = learnt(1), cliff = learnt(1, {}, {.environment = "cliff", .features = "table"});
  expectQuestionRefused({&f, &cliff}, {}, "two of one environment");
  expectQuestionRefused({&f}, {.push = "1001"}, "1001");
  expectQuestionRefused({&f}, {.pushAt = "-1"}, "--push-at");
  expectQuestionRefused({&f}, {.pushAt = "700"}, "600");
  expectQuestionRefused({&f}, {.seconds = "0"}, "--seconds");
  expectQuestionRefused({&f}, {.scenario = "9"}, "9");
  expectQuestionRefused({&f}, {.scenario = "1;1"}, "twice");
  expectQuestionRefused({&f}, {.settings = {"environment.frction=0"}}, "environment.friction");
  expectQuestionRefused({&f}, {.settings = {"environment.friction=-1"}}, "environment.friction");
  expectQuestionRefused({&f}, {.settings = {"environment.friction=0", "environment.friction=1"}}, "twice");
  expectQuestionRefused({&f}, {.settings = {"environment.start_angle=1.5;0.1"}}, "the model \"start_angle = 1.5 rad\"");
  expectQuestionRefused({&f}, {.settings = {"agent.discount=0.5"}}, "nothing is learned");
  expectQuestionRefused({&f}, {.settings = {"policy.temperature=1"}}, "greedy");
  expectQuestionRefused({&f}, {.settings = {"friction"}}, "KEY=VALUES");
  expectQuestionRefused({&f}, {.policy = "softmacks"}, "softmax");
  expectQuestionRefused({&f}, {.starts = "0"}, "--starts");
  expectQuestionRefused({&f}, {.seed = "-1"}, "--seed");
  expectQuestionRefused({&f}, {.push = "0..1:1000", .starts = "100000"}, "at most 10,000,000");
  expectQuestionRefused({&f}, {.settings = {"environment.friction=0..0.1:1000", "environment.damping=0..0.1:1000"}},
                        "1,000,000 models");
  expectQuestionRefused({&f}, {.push = "0..1:1000", .settings = {"environment.friction=0..0.1:1000"}},
                        "1,000,000 cells");
}

TEST(Robustness, ItsCommandAsksTheSame) {
  const RobustnessQuestion q{.push = "0;1",
                             .scenario = "all",
                             .settings = {"environment.friction=0..0.1:5"},
                             .policy = "softmax",
                             .starts = "10"};
  EXPECT_EQ(robustnessCommandLine(q, {"a b.safetensors", "c"}),
            "surefoot robustness 'a b.safetensors' c --push '0;1' --scenario all --set "
            "'environment.friction=0..0.1:5' --policy softmax --starts 10");
}

}  // namespace surefoot
