// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/td_control.h"

#include "tests/core/agents/row_of_states.h"

namespace surefoot {

namespace {

constexpr double kExact = 1e-12;  // a handful of roundings

}  // namespace

// By hand, α = .5, γ = .9, λ = .8, γλ = .72. Step 0 → 1 with R = 1: δ = 1, w(0) = .5.
// End with R = 2: δ = 2 − 0, z(1) = 1, z(0) = .72: w(1) = 1, w(0) = .5 + .5·2·.72 = 1.22.
TEST(Sarsa, FollowsAHandComputedEpisode) {
  RowOfStates<> c({0.5, 0.9, 0.8});
  c.start(0);
  c.step(1, 1);
  EXPECT_NEAR(c.q(0, 0), 0.5, kExact);
  c.end(2);
  EXPECT_NEAR(c.q(1, 0), 1.0, kExact);
  EXPECT_NEAR(c.q(0, 0), 1.22, kExact);
  EXPECT_EQ(c.q(0, 1), 0.0);
}

// Going on by hand: 0 → 0 with R = 0: δ = .9·1.22 − 1.22 = −.122, w(0) = 1.159. 0 → 1 with R = 1: δ = 1 + .9·1 − 1.159
// = .741, z(0) = 1 again, w(0) = 1.5295. Cut off at 2 with R = 0: δ = 0 + .9·0 − 1 = −1, z(1) = 1, z(0) = .72:
// w(1) = .5, w(0) = 1.1695.
TEST(Sarsa, ReplacesTheTraceOfAPairVisitedAgain) {
  RowOfStates<> c({0.5, 0.9, 0.8});
  c.start(0), c.step(1, 1), c.end(2);
  c.start(0);
  c.step(0, 0);
  EXPECT_NEAR(c.q(0, 0), 1.159, kExact);
  c.step(1, 1);
  EXPECT_NEAR(c.q(0, 0), 1.5295, kExact);
  c.truncate(0, 2);
  EXPECT_NEAR(c.q(1, 0), 0.5, kExact);
  EXPECT_NEAR(c.q(0, 0), 1.1695, kExact);
}

// The same with accumulating traces: z(0) = 1.72 in the step 0 → 1, so w(0) = 1.159 + .5·.741·1.72 = 1.79626.
TEST(Sarsa, AccumulatesTheTraceIfAsked) {
  RowOfStates<> c({0.5, 0.9, 0.8, TraceKind::Accumulating});
  c.start(0), c.step(1, 1), c.end(2);
  c.start(0), c.step(0, 0), c.step(1, 1);
  EXPECT_NEAR(c.q(0, 0), 1.79626, kExact);
}

// A terminal state is worth 0 although its features have a value; a state at a time limit is worth its value.
TEST(Sarsa, TellsTerminalFromTruncated) {
  RowOfStates<> c({1.0, 0.9, 0.0});
  c.start(1), c.end(10);  // w(1) = 10
  c.start(0), c.truncate(0, 1);
  EXPECT_NEAR(c.q(0, 0), 9.0, kExact);
  c.start(2), c.end(0);
  EXPECT_NEAR(c.q(2, 0), 0.0, kExact);
}

TEST(Sarsa, OtherActionsKeepOrLoseTheirTraces) {
  for (const OtherActions other : {OtherActions::Keep, OtherActions::Clear}) {
    RowOfStates<> c({1.0, 1.0, 1.0, TraceKind::Replacing, other});
    c.policy.action = 0;
    c.start(0);
    c.policy.action = 1;
    c.step(0, 0);  // (0, action 0) → (0, action 1)
    c.end(1);
    EXPECT_NEAR(c.q(0, 1), 1.0, kExact);
    EXPECT_NEAR(c.q(0, 0), other == OtherActions::Keep ? 1.0 : 0.0, kExact);
  }
}

// eq. 2.10: α = 1 closes the whole error, whatever the number of tilings.
TEST(Sarsa, AStepSizeOfOneClosesTheWholeError) {
  for (const int tilings : {1, 4, 16}) {
    RowOfStates<> c({1.0, 0.9, 0.0}, tilings);
    c.start(3), c.end(7.5);
    EXPECT_NEAR(c.q(3, 0), 7.5, kExact);
  }
}

TEST(Sarsa, NoticesDivergence) {
  RowOfStates<> c({2.0, 1.0, 1.0, TraceKind::Accumulating});
  EXPECT_FALSE(c.agent->diverged());
  for (int i = 0; i < 2000 && !c.agent->diverged(); ++i)
    c.start(0), c.step(1e6, 0), c.step(1e6, 1), c.step(1e6, 0), c.end(1e6);
  EXPECT_TRUE(c.agent->diverged());
}

// By hand: w(1, action 0) = 4 and w(1, action 1) = 10, then 0 → 1 with R = 1, γ = .5, the script choosing action 0.
// Sarsa: δ = 1 + .5·4; Q-learning: δ = 1 + .5·10; Expected Sarsa under a policy of ¼ and ¾: δ = 1 + .5·(1 + 7.5).
template <class Target>
double valueAfterOneStep(double probabilityOfTheSecond) {
  RowOfStates<Target> c({1.0, 0.5, 0.0});
  c.policy.action = 0;
  c.start(1), c.end(4);
  c.policy.action = 1;
  c.start(1), c.end(10);
  c.policy.action = 0;
  c.start(0);
  c.policy.second = probabilityOfTheSecond;
  c.step(1, 1);
  return c.q(0, 0);
}

TEST(Targets, DifferAsTheirEquationsSay) {
  EXPECT_NEAR(valueAfterOneStep<SarsaTarget>(0.0), 3.0, kExact);
  EXPECT_NEAR(valueAfterOneStep<WatkinsTarget>(0.0), 6.0, kExact);
  EXPECT_NEAR(valueAfterOneStep<ExpectedTarget>(0.75), 1 + 0.5 * (0.25 * 4 + 0.75 * 10), kExact);
}

// After an exploratory action the pairs before it learn nothing more; after a greedy one they do. γ = λ = 1, α = 1:
// 0 → 1 → end with 5. (1, 0) is worth 2 before, (1, 1) nothing.
TEST(QLearning, CutsTheTraceBeforeAnExploratoryAction) {
  for (const Action second : {0, 1}) {
    RowOfStates<WatkinsTarget> c({1.0, 1.0, 1.0});
    c.start(1), c.end(2);
    c.start(0);                // action 0
    c.policy.action = second;  // greedy in state 1: 0
    c.step(0, 1);              // (0, 0) ← max = 2
    c.end(5);                  // δ = 5 − 2 for the greedy action, 5 − 0 for the other
    EXPECT_NEAR(c.q(0, 0), second == 0 ? 5.0 : 2.0, kExact);
  }
}

// Ties count as greedy: nothing has been learned, every action is.
TEST(QLearning, ATieIsGreedy) {
  const std::vector<double> q = {1, 3, 3};
  EXPECT_TRUE(WatkinsTarget::cutsTrace(q, 0));
  EXPECT_FALSE(WatkinsTarget::cutsTrace(q, 1));
  EXPECT_FALSE(WatkinsTarget::cutsTrace(q, 2));
}

// λ = 0 with any rule of traces is the one-step rule Q ← Q + α δ.
TEST(Sarsa, WithoutTracesIsTheOneStepRule) {
  for (const TraceKind kind : {TraceKind::Replacing, TraceKind::Accumulating}) {
    RowOfStates<> c({0.3, 0.9, 0.0, kind});
    std::vector<double> plain(10, 0.0);
    Random random(3);
    for (int episode = 0; episode < 50; ++episode) {
      int s = static_cast<int>(random.next() % 10);
      c.start(s);
      for (int step = 0; step < 20; ++step) {
        const int next = static_cast<int>(random.next() % 10);
        const double r = random.uniform(-1, 1);
        c.step(r, next);
        plain[static_cast<std::size_t>(s)] +=
            0.3 * (r + 0.9 * plain[static_cast<std::size_t>(next)] - plain[static_cast<std::size_t>(s)]);
        s = next;
      }
      c.end(1);
      plain[static_cast<std::size_t>(s)] += 0.3 * (1 - plain[static_cast<std::size_t>(s)]);
    }
    for (int s = 0; s < 10; ++s) EXPECT_NEAR(c.q(s, 0), plain[static_cast<std::size_t>(s)], 1e-12);
  }
}

// An episode that is given up teaches nothing any more: what comes after it must not reach back over its trace.
TEST(Sarsa, AnAbandonedEpisodeLeavesNoTrace) {
  for (const TraceKind kind : {TraceKind::Replacing, TraceKind::Accumulating}) {
    RowOfStates<> c({0.5, 0.9, 0.8, kind});
    c.start(0);
    c.step(1, 1);
    EXPECT_NEAR(c.q(0, 0), 0.5, kExact);
    c.agent->abandon();
    std::vector<Eligibility> z;
    c.agent->eligibility(z);
    EXPECT_TRUE(z.empty());
    c.start(5);
    c.end(10);
    EXPECT_NEAR(c.q(5, 0), 5.0, kExact);
    EXPECT_NEAR(c.q(0, 0), 0.5, kExact);
  }
}

// By hand, α = .5, γ = .9, λ = 0, κ = .2: a first δ of 1 counts 0.8, one of −1 counts 1.2.
TEST(Sarsa, WeighsBadNewsMoreByItsAsymmetry) {
  for (const double reward : {1.0, -1.0}) {
    RowOfStates<> c({0.5, 0.9, 0.0});
    Fields f("agent.");
    c.agent->declare(f);
    for (const auto& field : f.all())
      if (field.parameter.key == "agent.asymmetry") field.set(0.2);
    c.start(0);
    c.end(reward);
    EXPECT_NEAR(c.q(0, 0), reward > 0 ? 0.4 : -0.6, kExact);
  }
}

}  // namespace surefoot
