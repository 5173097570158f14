// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signals/rollout.h"

#include <cmath>

#include "core/life/greedy_trial.h"
#include "core/life/life_measures.h"
#include "core/policies/greedy.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

const Registry& registry() {
  static const Registry all = fullRegistry();
  return all;
}

Configuration configured(const Names& names, const std::vector<Assignment>& assignments = {}) {
  auto c = configure(registry(), names, assignments);
  EXPECT_TRUE(c) << (c ? "" : c.error().message);
  return *c;
}

std::unique_ptr<Life> lived(Configuration c, int episodes) {
  c.episodes = episodes;
  auto life = makeLife(registry(), c, 0, false);
  EXPECT_TRUE(life) << (life ? "" : life.error().message);
  while (!(*life)->finished()) (*life)->step();
  return std::move(*life);
}

Rollout rolledOut(const Configuration& c, const Life& life, const RolloutSettings& settings) {
  const auto environment = makeEnvironment(registry(), c);
  return rollOut(**environment, life.agent().values(), Greedy(), settings);
}

}  // namespace

TEST(Rollout, HasARowAStepAndAColumnASignal) {
  const Configuration c = configured({});
  const auto life = lived(c, 100);
  const Rollout r = rolledOut(c, *life, {.steps = 1000, .discount = 0.98});
  ASSERT_EQ(r.table.signals().size(), r.table.columns().size());
  for (std::size_t i = 0; i < r.table.columns().size(); ++i)
    EXPECT_EQ(r.table.columns()[i].size(), 1000u) << r.table.signals()[i].key;
  EXPECT_DOUBLE_EQ(r.table.column("time")->at(200), 1.0);
  double reward = 0.0;
  std::int64_t falls = 0, ends = 0;
  for (std::size_t row = 0; row < 1000; ++row) {
    reward += r.table.column("reward")->at(row);
    falls += r.table.column("fall")->at(row) != 0.0;
    ends += r.table.column("end")->at(row) != 0.0;
    EXPECT_EQ(r.table.column("value")->at(row), r.table.column("q")->at(row)) << "greedy";
    const double parts = r.table.column("reward_goal")->at(row) + r.table.column("reward_fall")->at(row) +
                         r.table.column("reward_time")->at(row);
    EXPECT_EQ(r.table.column("reward")->at(row), parts);
  }
  EXPECT_EQ(reward, r.reward);
  EXPECT_EQ(falls, r.falls);
  EXPECT_EQ(r.falls + r.successes, ends);
}

// δ = r + γ Q(s′, a′) − Q(s, a), with Q(s′, a′) = 0 behind a terminal step.
TEST(Rollout, HasTheTdErrorOfEveryStep) {
  const Configuration c = configured({});
  const auto life = lived(c, 100);
  const Rollout r = rolledOut(c, *life, {.steps = 500, .discount = 0.9});
  const auto &q = *r.table.column("q"), &reward = *r.table.column("reward"), &end = *r.table.column("end"),
             &delta = *r.table.column("td_error");
  for (std::size_t row = 0; row + 1 < 500; ++row)
    EXPECT_EQ(delta[row], reward[row] + (end[row] != 0.0 ? 0.0 : 0.9 * q[row + 1]) - q[row]) << row;
}

TEST(Rollout, IsTheSameTwiceAndWithAnotherSeedAnother) {
  const Configuration c = configured({});
  const auto life = lived(c, 50);
  const Rollout first = rolledOut(c, *life, {.seed = 5, .steps = 400}),
                again = rolledOut(c, *life, {.seed = 5, .steps = 400});
  const Rollout other = rolledOut(c, *life, {.seed = 6, .steps = 400});
  EXPECT_EQ(*first.table.column("pole_angle"), *again.table.column("pole_angle"));
  EXPECT_EQ(*first.table.column("energy"), *again.table.column("energy"));
  EXPECT_NE(*first.table.column("pole_angle"), *other.table.column("pole_angle"));
}

TEST(Rollout, OfLeoIsItsGreedyTest) {
  const Configuration c = configured({.environment = "leo"}, {{"features.memory", "65536"}});
  const auto life = lived(c, 60);
  ASSERT_FALSE(life->greedyTests().empty());
  const GreedyTest& test = life->greedyTests().back();
  ASSERT_EQ(test.episode, 60) << "tested when the life ended";
  const Rollout r = rolledOut(c, *life, {.steps = 10'000, .episodes = 1});
  EXPECT_EQ(r.steps, test.steps);
  EXPECT_EQ(r.reward, test.reward);
  for (std::size_t m = 0; m < 3; ++m) EXPECT_EQ(r.measures[m], test.measures[m]);
  // What the signals say is what the measures say.
  const auto& hip = *r.table.column("hip_position");
  EXPECT_NEAR(hip.back() - hip.front(), r.measures[0], 0.1);
  const auto &heel = *r.table.column("left_heel"), &toe = *r.table.column("left_toe");
  EXPECT_GT(std::count(heel.begin(), heel.end(), 1.0) + std::count(toe.begin(), toe.end(), 1.0), 0);
  double work = 0.0;  // of hips and knees, as the reward counts it
  for (const char* joint : {"left_hip", "right_hip", "left_knee", "right_knee"})
    for (const double power : *r.table.column(std::string(joint) + "_power")) work += std::max(0.0, power) / 30.0;
  EXPECT_NEAR(work / r.measures[2], 1.0, 0.5) << "power at the ends of the steps, energy over them";
}

// Its measures are a life's: a sum, a mean, the last or the largest of the episodes.
TEST(Rollout, MeasuresItsEpisodesAsALifeDoes) {
  const Configuration c = configured({.environment = "compass"});
  const auto life = lived(c, 20);
  const Rollout whole = rolledOut(c, *life, {.steps = 20'000, .episodes = 6});
  const auto& measures = life->environment().task().measures;
  EpisodeLog log(false, measures);
  const auto environment = makeEnvironment(registry(), c);
  const auto &action = *whole.table.column("action"), &end = *whole.table.column("end");
  Random world(deriveSeed(1, 0, Stream::World));
  (*environment)->reset(world);
  for (std::size_t row = 0; row < action.size(); ++row) {
    const Outcome outcome = (*environment)->step(static_cast<Action>(action[row]));
    log.add(outcome);
    ASSERT_EQ(outcome.ending != Ending::None, end[row] != 0.0);
    if (outcome.ending == Ending::None) continue;
    log.finish(outcome.ending, static_cast<std::int64_t>(row) + 1, 0.0, (*environment)->measures());
    (*environment)->reset(world);
  }
  ASSERT_EQ(log.totals().episodes, 6);
  for (std::size_t m = 0; m < measures.size(); ++m)
    EXPECT_EQ(whole.measures[m], valueOfALife(measures[m], log.totals().measures[m], 6)) << measures[m].key;
}

TEST(Rollout, BeginsWhereItIsToldAndIsPushed) {
  const Configuration c = configured({});
  const auto life = lived(c, 1);
  const Rollout r = rolledOut(c, *life, {.start = {0.3, -1.0, 2.0}, .steps = 30});
  EXPECT_NEAR(r.table.column("pole_angle")->front(), 0.3, 1e-6);
  EXPECT_NEAR(r.table.column("pole_rate")->front(), -1.0, 1e-6);
  const Rollout pushed = rolledOut(c, *life, {.start = {0.3, -1.0, 2.0}, .steps = 30, .pushes = {{0.05, 0.02}}});
  EXPECT_EQ(pushed.table.column("pole_rate")->at(10), r.table.column("pole_rate")->at(10))
      << "the step of the push begins there";
  EXPECT_GT(pushed.table.column("pole_rate")->at(11), r.table.column("pole_rate")->at(11));
}

/// How much energy the pendulum gains in a tenth of a second without torque, damping and friction [J].
double driftWith(const char* substeps) {
  const Configuration c =
      configured({}, {{"environment.damping", "0"}, {"environment.friction", "0"}, {"environment.substeps", substeps}});
  const auto environment = makeEnvironment(registry(), c);
  EXPECT_TRUE((*environment)->place(std::vector<double>{0.5, 0.0, 0.0}));
  std::vector<double> values((*environment)->signals().size());
  (*environment)->readSignals(values);
  const double before = values[3];
  EXPECT_LT(before, -0.05);
  for (int i = 0; i < 20; ++i) EXPECT_EQ((*environment)->step(2).ending, Ending::None);
  (*environment)->readSignals(values);
  EXPECT_EQ(values[2], 0.0) << "no torque, no power";
  return values[3] - before;
}

// The energy stays, but for the error of the time step, which shrinks with it.
TEST(Rollout, EnergyOfThePendulumStays) {
  const double coarse = driftWith("1"), fine = driftWith("10");
  EXPECT_LT(std::abs(coarse), 0.015);
  EXPECT_LT(std::abs(fine), 0.2 * std::abs(coarse));
}

TEST(Signals, LookingChangesNoBit) {
  for (const char* name : {"pendulum", "compass", "leo"}) {
    const Configuration c = configured({.environment = name});
    const auto looked = makeEnvironment(registry(), c), alone = makeEnvironment(registry(), c);
    Random a(3), b(3), actions(4);
    (*looked)->reset(a), (*alone)->reset(b);
    std::vector<double> values((*looked)->signals().size());
    for (int i = 0; i < 200; ++i) {
      (*looked)->readSignals(values);
      const auto action =
          static_cast<Action>(actions.uniform() * static_cast<double>((*looked)->task().actions.size()));
      const Outcome here = (*looked)->step(action), there = (*alone)->step(action);
      ASSERT_EQ(here.reward, there.reward);
      ASSERT_TRUE(std::ranges::equal((*looked)->state(), (*alone)->state()));
      if (here.ending != Ending::None) (*looked)->reset(a), (*alone)->reset(b);
    }
  }
}

// A roll-out from where another one began, with its pushes, is that one; and lived again by its actions as well.
TEST(Rollout, BeginsAsAnotherOneAndIsLivedAgain) {
  const Configuration c = configured({});
  const auto life = lived(c, 30);
  EpisodeInputs inputs;
  inputs.random = Random(77).state();
  inputs.start = {2.0, 0.5, 0.0};
  inputs.pushSteps = {3, 3, 20};
  inputs.pushImpulses = {0.01, 0.02, -0.05};
  const Rollout first = rolledOut(c, *life, {.steps = 5000, .episodes = 1, .discount = 0.9, .as = &inputs});
  EXPECT_NEAR(first.table.column("pole_angle")->front(), 2.0, 1e-6);
  for (const double a : *first.table.column("action")) inputs.actions.push_back(static_cast<std::uint16_t>(a));
  const auto environment = makeEnvironment(registry(), c);
  std::size_t seen = 0;
  const SignalTable again =
      relive(**environment, inputs, &life->agent().values(), Greedy(), 0.9, [&](const RolloutMoment& m) {
        EXPECT_EQ(m.row, static_cast<std::int64_t>(seen));
        EXPECT_EQ(m.next == kNoAction, seen == inputs.actions.size());
        ++seen;
      });
  ASSERT_EQ(again.rows(), first.table.rows() + 1) << "and the state that it ended in";
  EXPECT_EQ(seen, again.rows());
  for (std::size_t i = 0; i < again.signals().size(); ++i) {
    if (again.signals()[i].key == "explored") continue;
    for (std::size_t row = 0; row < first.table.rows(); ++row) {
      const double a = first.table.columns()[i][row], b = again.columns()[i][row];
      EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << again.signals()[i].key << " in row " << row;
    }
  }
  EXPECT_TRUE(std::isnan(again.column("action")->back()));
  inputs.actions.push_back(0);
  EXPECT_EQ(relive(**environment, inputs, nullptr, Greedy(), 0.9).rows(), 0u) << "it was over before";
}

TEST(Rollout, KeysAreThereOnce) {
  for (const char* name : {"pendulum", "compass", "leo", "cliff"}) {
    const auto environment = makeEnvironment(registry(), configured({.environment = name}));
    const std::vector<Signal> all = signalsOf(**environment, true);
    for (const Signal& s : all)
      EXPECT_EQ(std::count_if(all.begin(), all.end(), [&](const Signal& t) { return t.key == s.key; }), 1)
          << name << ": " << s.key;
  }
}

}  // namespace surefoot
