// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/sarsa_lambda.h"

#include <gtest/gtest.h>

#include "core/features/tile_coder.h"

namespace surefoot {

namespace {

/// Always the action that the test names.
class Scripted final : public Policy {
 public:
  Action action = 0;
  void declare(Fields&) override {}
  void probabilities(std::span<const double> q, std::span<double> pi) const override {
    for (std::size_t a = 0; a < q.size(); ++a) pi[a] = static_cast<int>(a) == action ? 1.0 : 0.0;
  }
};

/// States 0, 1, 2, … each with a tile of its own; two actions; weights from 0.
struct Corridor {
  explicit Corridor(SarsaSettings settings, int tilings = 1) {
    Task task;
    task.state = {{.key = "s", .title = "s", .low = 0, .high = 9, .span = 1, .resolution = 1}};
    task.actions = {0, 1};
    TileCoder::Settings tiles(task);
    tiles.tilings = tilings;
    agent = std::make_unique<SarsaLambda<TileCoder>>(
        LinearActionValue<TileCoder>(*TileCoder::create(task, tiles), 2, {0.0, 0.0}, 1), settings);
    agent->setPolicy(policy);
  }
  double q(double state, Action a) const {
    std::vector<double> values(2);
    agent->values().evaluate(std::vector<double>{state}, Layer::Sum, values);
    return values[static_cast<std::size_t>(a)];
  }
  void start(double s) { agent->start(std::vector<double>{s}, random); }
  void step(double reward, double s) { agent->step({.reward = reward}, std::vector<double>{s}, random); }
  void truncate(double reward, double s) { agent->truncate({.reward = reward}, std::vector<double>{s}, random); }
  void end(double reward) { agent->end({.reward = reward}); }

  Scripted policy;
  Random random{1};
  std::unique_ptr<SarsaLambda<TileCoder>> agent;
};

SarsaSettings settings(double stepSize, double discount, double traceDecay) {
  return {.stepSize = stepSize, .discount = discount, .traceDecay = traceDecay, .traceCutoff = 0.0};
}

constexpr double kExact = 1e-12;  // a handful of roundings

}  // namespace

// By hand, α = .5, γ = .9, λ = .8, γλ = .72. Step 0 → 1 with R = 1: δ = 1, w(0) = .5.
// End with R = 2: δ = 2 − 0, z(1) = 1, z(0) = .72: w(1) = 1, w(0) = .5 + .5·2·.72 = 1.22.
TEST(SarsaLambda, FollowsAHandComputedEpisode) {
  Corridor c(settings(0.5, 0.9, 0.8));
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
TEST(SarsaLambda, ReplacesTheTraceOfAPairVisitedAgain) {
  Corridor c(settings(0.5, 0.9, 0.8));
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
TEST(SarsaLambda, AccumulatesTheTraceIfAsked) {
  SarsaSettings s = settings(0.5, 0.9, 0.8);
  s.trace = TraceKind::Accumulating;
  Corridor c(s);
  c.start(0), c.step(1, 1), c.end(2);
  c.start(0), c.step(0, 0), c.step(1, 1);
  EXPECT_NEAR(c.q(0, 0), 1.79626, kExact);
}

// A terminal state is worth 0 although its features have a value; a state at a time limit is worth its value.
TEST(SarsaLambda, TellsTerminalFromTruncated) {
  Corridor c(settings(1.0, 0.9, 0.0));
  c.start(1), c.end(10);  // w(1) = 10
  c.start(0), c.truncate(0, 1);
  EXPECT_NEAR(c.q(0, 0), 9.0, kExact);
  c.start(2), c.end(0);
  EXPECT_NEAR(c.q(2, 0), 0.0, kExact);
}

TEST(SarsaLambda, OtherActionsKeepOrLoseTheirTraces) {
  for (const OtherActions other : {OtherActions::Keep, OtherActions::Clear}) {
    SarsaSettings s = settings(1.0, 1.0, 1.0);
    s.otherActions = other;
    Corridor c(s);
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
TEST(SarsaLambda, AStepSizeOfOneClosesTheWholeError) {
  for (const int tilings : {1, 4, 16}) {
    Corridor c(settings(1.0, 0.9, 0.0), tilings);
    c.start(3), c.end(7.5);
    EXPECT_NEAR(c.q(3, 0), 7.5, kExact);
  }
}

TEST(SarsaLambda, NoticesDivergence) {
  SarsaSettings s = settings(2.0, 1.0, 1.0);
  s.trace = TraceKind::Accumulating;
  Corridor c(s);
  EXPECT_FALSE(c.agent->diverged());
  for (int i = 0; i < 2000 && !c.agent->diverged(); ++i)
    c.start(0), c.step(1e6, 0), c.step(1e6, 1), c.step(1e6, 0), c.end(1e6);
  EXPECT_TRUE(c.agent->diverged());
}

}  // namespace surefoot
