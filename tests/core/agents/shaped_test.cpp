// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/shaped.h"

#include <gtest/gtest.h>

#include "core/agents/td_control.h"
#include "core/features/table.h"
#include "core/policies/greedy.h"

namespace surefoot {

namespace {

Task corridor() {
  Task task;
  task.state = {{.key = "s", .title = "s", .low = 0, .high = 4, .whole = true}};
  task.actions = {0};
  task.rewardTerms = {"gain", "loss"};
  return task;
}

Estimate<Table> estimate(const EstimateSettings& learning) {
  return Estimate<Table>(LinearActionValue<Table>(*Table::create(corridor()), 1, {0.0, 0.0}, 1), learning);
}

struct Shaped {
  explicit Shaped(Shaping kind, double traceDecay = 0.0) {
    auto inner = std::make_unique<TdControl<SarsaTarget, Table>>(estimate({1.0, 0.0}), ControlSettings{0.9, {}});
    agent = std::make_unique<ShapedAgent<Table>>(std::move(inner), estimate({0.5, traceDecay}),
                                                 ShapingSettings{kind, 0.8, 0.5}, 2);
    agent->setPolicy(policy);
  }
  double q(double s) const { return look(agent->values(), s); }
  double v(double s) const { return look(agent->potential(), s); }
  static double look(const ActionValueFunction& f, double s) {
    double value = 0;
    f.evaluate(std::vector<double>{s}, Layer::Sum, std::span(&value, 1));
    return value;
  }
  /// 0 → 1 → end, with a gain of 10 and a loss of −4 at the end.
  void episode() {
    agent->start(std::vector<double>{0}, random);
    agent->step({}, std::vector<double>{1}, random);
    Outcome last{.reward = 6, .ending = Ending::Terminal};
    last.terms[0] = 10, last.terms[1] = -4;
    agent->end(last);
  }
  Greedy policy;
  Random random{1};
  std::unique_ptr<ShapedAgent<Table>> agent;
};

}  // namespace

// By hand, α = 1, γ = .9, α_v = .5, γ_v = .8, V on all rewards.
// First episode: F = 0 at 0 → 1; V(0) = 0. At the end F = 0 − V(1) = 0, Q(1) = 6, V(1) = .5·6 = 3.
// Second: 0 → 1: F = .8·3 − 0 = 2.4, Q(0) = 2.4 + .9·6 = 7.8, V(0) = .5·.8·3 = 1.2. End: F = −3, Q(1) = 6 − 3 = 3,
// V(1) = 3 + .5·(6 − 3) = 4.5.
TEST(ShapedAgent, FollowsEquations65And66ByHand) {
  Shaped s(Shaping::All);
  s.episode();
  EXPECT_NEAR(s.q(1), 6.0, 1e-12);
  EXPECT_NEAR(s.v(1), 3.0, 1e-12);
  s.episode();
  EXPECT_NEAR(s.q(0), 7.8, 1e-12);
  EXPECT_NEAR(s.v(0), 1.2, 1e-12);
  EXPECT_NEAR(s.q(1), 3.0, 1e-12);
  EXPECT_NEAR(s.v(1), 4.5, 1e-12);
}

TEST(ShapedAgent, ThePotentialLearnsFromTheRewardsItIsGiven) {
  Shaped losses(Shaping::Losses), gains(Shaping::Gains);
  losses.episode();
  gains.episode();
  EXPECT_NEAR(losses.v(1), -2.0, 1e-12);
  EXPECT_NEAR(gains.v(1), 5.0, 1e-12);
}

// Cut off at 1, after the first episode of above: V(S′) = 3 counts, so F = .8·3 − 0 = 2.4, Q(0) = 2.4 + .9·6 = 7.8,
// V(0) = .5·.8·3 = 1.2.
TEST(ShapedAgent, WhereATimeLimitCutsOffTheStateAfterItHasItsValue) {
  Shaped s(Shaping::All);
  s.episode();
  s.agent->start(std::vector<double>{0}, s.random);
  s.agent->truncate({.ending = Ending::Truncated}, std::vector<double>{1}, s.random);
  EXPECT_NEAR(s.q(0), 7.8, 1e-12);
  EXPECT_NEAR(s.v(0), 1.2, 1e-12);
}

TEST(ShapedAgent, AnAbandonedEpisodeLeavesThePotentialNoTrace) {
  Shaped s(Shaping::All, 0.9);
  s.agent->start(std::vector<double>{0}, s.random);
  s.agent->step({}, std::vector<double>{1}, s.random);
  s.agent->abandon();
  s.agent->start(std::vector<double>{3}, s.random);
  s.agent->end({.reward = 10, .ending = Ending::Terminal});
  EXPECT_NEAR(s.v(3), 5.0, 1e-12);
  EXPECT_EQ(s.v(0), 0.0);
}

// A potential that never learns stays 0 everywhere, so F is 0.
TEST(ShapedAgent, WithoutAPotentialNothingChanges) {
  auto plain = std::make_unique<TdControl<SarsaTarget, Table>>(estimate({1.0, 0.0}), ControlSettings{0.9, {}});
  Greedy policy;
  plain->setPolicy(policy);
  auto still = std::make_unique<ShapedAgent<Table>>(
      std::make_unique<TdControl<SarsaTarget, Table>>(estimate({1.0, 0.0}), ControlSettings{0.9, {}}),
      estimate({0.0, 0.0}), ShapingSettings{Shaping::All, 0.9, 0.0}, 2);
  still->setPolicy(policy);
  Random random(1);
  for (Agent* agent : {static_cast<Agent*>(plain.get()), static_cast<Agent*>(still.get())})
    for (int episode = 0; episode < 3; ++episode) {
      agent->start(std::vector<double>{0}, random);
      agent->step({.reward = -1}, std::vector<double>{1}, random);
      agent->step({.reward = -1}, std::vector<double>{2}, random);
      agent->truncate({.reward = 5}, std::vector<double>{3}, random);
    }
  for (double s = 0; s < 4; ++s) EXPECT_EQ(Shaped::look(plain->values(), s), Shaped::look(still->values(), s));
}

}  // namespace surefoot
