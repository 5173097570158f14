// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/td_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/features/tile_coder.h"

namespace surefoot {

namespace {

/// Always the action that the test names; or, if `second` is set, the second of two with that probability.
class Scripted final : public Policy {
 public:
  Action action = 0;
  double second = 0.0;
  void declareRule(Fields&) override {}
  void among(std::span<const double> q, std::span<double> pi) const override {
    for (std::size_t a = 0; a < q.size(); ++a) pi[a] = static_cast<int>(a) == action ? 1.0 : 0.0;
    if (second > 0.0) pi[0] = 1.0 - second, pi[1] = second;
  }
};

/// α, γ, λ and the kind of trace; the cut-off is 0.
struct Settings {
  double stepSize, discount, traceDecay;
  TraceKind trace = TraceKind::Replacing;
  OtherActions otherActions = OtherActions::Keep;
};

/// States 0, 1, 2, … each with a tile of its own; two actions; weights from 0.
template <class Target = SarsaTarget>
struct Corridor {
  explicit Corridor(const Settings& s, int tilings = 1) {
    Task task;
    task.state = {{.key = "s", .title = "s", .low = 0, .high = 9, .span = 1, .resolution = 1}};
    task.actions = {0, 1};
    TileCoder::Settings tiles(task);
    tiles.tilings = tilings;
    LinearActionValue<TileCoder> values(*TileCoder::create(task, tiles), 2, {0.0, 0.0}, 1);
    agent = std::make_unique<TdControl<Target, TileCoder>>(
        Estimate<TileCoder>(std::move(values), EstimateSettings{s.stepSize, s.traceDecay}),
        ControlSettings{s.discount, TraceSettings{0.0, s.trace, s.otherActions}});
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
  std::unique_ptr<Agent> agent;
};

constexpr double kExact = 1e-12;  // a handful of roundings

}  // namespace

// By hand, α = .5, γ = .9, λ = .8, γλ = .72. Step 0 → 1 with R = 1: δ = 1, w(0) = .5.
// End with R = 2: δ = 2 − 0, z(1) = 1, z(0) = .72: w(1) = 1, w(0) = .5 + .5·2·.72 = 1.22.
TEST(Sarsa, FollowsAHandComputedEpisode) {
  Corridor<> c({0.5, 0.9, 0.8});
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
  Corridor<> c({0.5, 0.9, 0.8});
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
  Corridor<> c({0.5, 0.9, 0.8, TraceKind::Accumulating});
  c.start(0), c.step(1, 1), c.end(2);
  c.start(0), c.step(0, 0), c.step(1, 1);
  EXPECT_NEAR(c.q(0, 0), 1.79626, kExact);
}

// A terminal state is worth 0 although its features have a value; a state at a time limit is worth its value.
TEST(Sarsa, TellsTerminalFromTruncated) {
  Corridor<> c({1.0, 0.9, 0.0});
  c.start(1), c.end(10);  // w(1) = 10
  c.start(0), c.truncate(0, 1);
  EXPECT_NEAR(c.q(0, 0), 9.0, kExact);
  c.start(2), c.end(0);
  EXPECT_NEAR(c.q(2, 0), 0.0, kExact);
}

TEST(Sarsa, OtherActionsKeepOrLoseTheirTraces) {
  for (const OtherActions other : {OtherActions::Keep, OtherActions::Clear}) {
    Corridor<> c({1.0, 1.0, 1.0, TraceKind::Replacing, other});
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
    Corridor<> c({1.0, 0.9, 0.0}, tilings);
    c.start(3), c.end(7.5);
    EXPECT_NEAR(c.q(3, 0), 7.5, kExact);
  }
}

TEST(Sarsa, NoticesDivergence) {
  Corridor<> c({2.0, 1.0, 1.0, TraceKind::Accumulating});
  EXPECT_FALSE(c.agent->diverged());
  for (int i = 0; i < 2000 && !c.agent->diverged(); ++i)
    c.start(0), c.step(1e6, 0), c.step(1e6, 1), c.step(1e6, 0), c.end(1e6);
  EXPECT_TRUE(c.agent->diverged());
}

// By hand: w(1, action 0) = 4 and w(1, action 1) = 10, then 0 → 1 with R = 1, γ = .5, the script choosing action 0.
// Sarsa: δ = 1 + .5·4; Q-learning: δ = 1 + .5·10; Expected Sarsa under a policy of ¼ and ¾: δ = 1 + .5·(1 + 7.5).
template <class Target>
double valueAfterOneStep(double probabilityOfTheSecond) {
  Corridor<Target> c({1.0, 0.5, 0.0});
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
    Corridor<WatkinsTarget> c({1.0, 1.0, 1.0});
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
    Corridor<> c({0.3, 0.9, 0.0, kind});
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
    Corridor<> c({0.5, 0.9, 0.8, kind});
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
    Corridor<> c({0.5, 0.9, 0.0});
    Fields f("agent.");
    c.agent->declare(f);
    for (const auto& field : f.all())
      if (field.parameter.key == "agent.asymmetry") field.set(0.2);
    c.start(0);
    c.end(reward);
    EXPECT_NEAR(c.q(0, 0), reward > 0 ? 0.4 : -0.6, kExact);
  }
}

namespace {

/// The online λ-return algorithm, the forward view that true online TD(λ) equals (van Seijen et al. 2016, section 3;
/// Sutton & Barto 2018, section 12.3): at every moment h all weights are computed anew from the beginning.
struct ForwardView {
  double stepSize, discount, traceDecay;
  std::vector<std::vector<double>> x{};       ///< features of every state
  std::vector<double> rewards{};              ///< rewards[t] comes after state t
  std::vector<std::vector<double>> online{};  ///< w_h, the result at moment h

  static double dot(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  }
  /// w_h from w_0; at the end of an episode state h has no features.
  std::vector<double> weightsAt(std::size_t h) const {
    std::vector<double> w = online[0];
    for (std::size_t t = 0; t < h; ++t) {
      double target = 0.0, sum = 0.0, power = 1.0;  // G_t^{λ|h} = (1 − λ) Σ λ^(n−1) G^(n) + λ^(h−t−1) G^(h−t)
      for (std::size_t n = 1; t + n <= h; ++n) {
        sum += std::pow(discount, static_cast<double>(n - 1)) * rewards[t + n - 1];
        const double bootstrap = dot(online[t + n - 1], x[t + n]);
        const double G = sum + std::pow(discount, static_cast<double>(n)) * bootstrap;
        target += (t + n == h ? power : (1.0 - traceDecay) * power) * G;
        power *= traceDecay;
      }
      const double error = target - dot(w, x[t]);
      for (std::size_t i = 0; i < w.size(); ++i) w[i] += stepSize / dot(x[t], x[t]) * error * x[t][i];
    }
    return w;
  }
};

}  // namespace

TEST(TrueOnlineSarsa, EqualsItsForwardViewAfterEveryStep) {
  constexpr int kTilings = 4;
  Corridor<TrueOnlineTarget> c({0.4, 0.9, 0.8}, kTilings);
  Task task;
  task.state = {{.key = "s", .title = "s", .low = 0, .high = 9, .span = 1, .resolution = 1}};
  TileCoder::Settings tiles(task);
  tiles.tilings = kTilings;
  const TileCoder coder = *TileCoder::create(task, tiles);
  const auto features = [&](double state) {
    TileCoder::Active active;
    coder.find(std::vector<double>{state}, active);
    std::vector<double> x(coder.size(), 0.0);
    for (const Index i : active.indices()) x[i] = 1.0;
    return x;
  };
  Random random(5);
  std::vector<double> weights(coder.size(), 0.0);
  for (int episode = 0; episode < 3; ++episode) {
    ForwardView view{0.4, 0.9, 0.8};
    double s = random.uniform(0, 3);  // states that share tiles
    c.start(s);
    view.x.push_back(features(s));
    view.online.push_back(weights);
    constexpr int kSteps = 15;
    for (int step = 1; step <= kSteps; ++step) {
      s = random.uniform(0, 3);
      const double reward = random.uniform(-1, 1);
      view.rewards.push_back(reward);
      view.x.push_back(step < kSteps ? features(s) : std::vector<double>(coder.size(), 0.0));
      if (step < kSteps)
        c.step(reward, s);
      else
        c.end(reward);
      view.online.push_back(view.weightsAt(static_cast<std::size_t>(step)));
      weights = view.online.back();
      for (double state = 0.1; state < 3.0; state += 0.37)
        EXPECT_NEAR(c.q(state, 0), ForwardView::dot(weights, features(state)), 1e-10)
            << "episode " << episode << ", step " << step;
    }
  }
}

}  // namespace surefoot
