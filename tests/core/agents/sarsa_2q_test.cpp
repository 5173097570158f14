// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/sarsa_2q.h"

#include <gtest/gtest.h>

#include "core/features/tile_coder.h"
#include "core/policies/epsilon_greedy.h"

namespace surefoot {

namespace {

constexpr double kLow = -1.0, kHigh = 1.0;

Task task() {
  Task t;
  for (const char* key : {"x", "y"})
    t.state.push_back({.key = key, .title = key, .low = kLow, .high = kHigh, .span = 1, .resolution = 3});
  t.actions = {0, 1, 2};
  t.rewardTerms = {"goal", "fall", "time"};
  return t;
}

using Values = LinearActionValue<TileCoder>;

Values values(const InitialValue& initial, std::uint64_t seed, double resolution = 3) {
  const Task t = task();
  TileCoder::Settings tiles(t);
  tiles.tilings = 8;
  tiles.resolution = {resolution, resolution};
  return Values(*TileCoder::create(t, tiles), 3, initial, seed);
}

const EstimateSettings kLearning{0.4, 0.92};
const ControlSettings kControl{0.98, {}};

std::unique_ptr<Agent> sarsa(const InitialValue& initial) {
  return std::make_unique<TdControl<SarsaTarget, TileCoder>>(Estimate<TileCoder>(values(initial, 7), kLearning),
                                                             kControl);
}

std::unique_ptr<Agent> sarsa2q(const InitialValue& positive, const InitialValue& negative, RewardSplit split,
                               double negativeResolution = 3) {
  return std::make_unique<Sarsa2Q<TileCoder, TileCoder>>(
      Estimate<TileCoder>(values(positive, 7), kLearning),
      Estimate<TileCoder>(values(negative, 7, negativeResolution), kLearning), kControl, std::move(split));
}

/// Feeds one recorded stream of states, actions and rewards to an agent, whatever it would like to do.
class Stream1e5 final : public Policy {
 public:
  void declareRule(Fields&) override {}
  void among(std::span<const double>, std::span<double> pi) const override {
    for (std::size_t a = 0; a < pi.size(); ++a) pi[a] = a == action ? 1.0 : 0.0;
  }
  std::size_t action = 0;

  void feed(Agent& agent, int steps, double fall) {
    Random random(2024), unused(1);
    std::vector<double> state(2);
    const auto move = [&] {
      for (double& x : state) x = random.uniform(kLow, kHigh);
      action = random.next() % 3;
    };
    agent.setPolicy(*this);
    bool fresh = true;
    for (int i = 0; i < steps; ++i) {
      move();
      if (fresh) {
        agent.start(state, unused);
        fresh = false;
        continue;
      }
      Outcome o;
      const double u = random.uniform();
      o.terms[0] = u < 0.02 ? 200.0 : 0.0;
      o.terms[1] = u > 0.98 ? fall : 0.0;
      o.terms[2] = random.uniform(-1, 0);
      o.reward = o.terms[0] + o.terms[1] + o.terms[2];
      fresh = u < 0.02 || u > 0.98;
      if (fresh)
        agent.end(o);
      else if (u < 0.03)
        agent.truncate(o, state, unused), fresh = true;
      else
        agent.step(o, state, unused);
    }
  }
};

double q(const Agent& agent, Layer layer, double x, double y, std::size_t a) {
  std::vector<double> values(3);
  agent.values().evaluate(std::vector<double>{x, y}, layer, values);
  return values[a];
}

}  // namespace

// Thesis, section 6.1.2 and claim A14: with equal representations, the initial weights halved, Q⁺ + Q⁻ is Sarsa's Q.
TEST(Sarsa2Q, EqualsSarsaAtEqualResolution) {
  const auto one = sarsa({0.0, 0.1});
  const auto two = sarsa2q({0.0, 0.05}, {0.0, 0.05}, RewardSplit(task().rewardTerms));
  Stream1e5 stream;
  stream.feed(*one, 100'000, -100);
  stream.feed(*two, 100'000, -100);
  double largest = 0.0;
  for (double x = kLow; x <= kHigh; x += 0.07)
    for (double y = kLow; y <= kHigh; y += 0.07)
      for (std::size_t a = 0; a < 3; ++a) {
        EXPECT_NEAR(q(*one, Layer::Sum, x, y, a), q(*two, Layer::Sum, x, y, a), 1e-9);
        EXPECT_EQ(q(*two, Layer::Sum, x, y, a), q(*two, Layer::Positive, x, y, a) + q(*two, Layer::Negative, x, y, a));
        largest = std::max(largest, std::abs(q(*one, Layer::Sum, x, y, a)));
      }
  EXPECT_GT(largest, 10.0) << "something was learned";
}

// Everything is linear in the reward: a fall four times as bad makes Q⁻ four times as large, and leaves Q⁺ alone.
TEST(Sarsa2Q, AFallFourTimesAsBadMakesTheLossesFourTimesAsLarge) {
  RewardSplit split(task().rewardTerms);
  Fields f("split.");
  split.declare(f);
  for (const auto& field : f.all())
    if (field.parameter.key == "split.time") field.set(1);  // the small losses of time go to Q⁺
  const auto mild = sarsa2q({0, 0}, {0, 0}, split), hard = sarsa2q({0, 0}, {0, 0}, split);
  Stream1e5 stream;
  stream.feed(*mild, 20'000, -100);
  stream.feed(*hard, 20'000, -400);
  for (double x = kLow; x <= kHigh; x += 0.1)
    for (std::size_t a = 0; a < 3; ++a) {
      EXPECT_NEAR(q(*hard, Layer::Negative, x, 0.3, a), 4 * q(*mild, Layer::Negative, x, 0.3, a), 1e-9);
      EXPECT_EQ(q(*hard, Layer::Positive, x, 0.3, a), q(*mild, Layer::Positive, x, 0.3, a));
    }
}

// Coarse tiles carry a loss farther than fine ones (Figure 6.1).
TEST(Sarsa2Q, ACoarserLossReachesFarther) {
  const auto fine = sarsa2q({0, 0}, {0, 0}, RewardSplit(task().rewardTerms), 6);
  const auto coarse = sarsa2q({0, 0}, {0, 0}, RewardSplit(task().rewardTerms), 1);
  EpsilonGreedy policy;
  Random random(1);
  Outcome fall;
  fall.terms[1] = fall.reward = -100;
  for (const auto& agent : {fine.get(), coarse.get()}) {
    agent->setPolicy(policy);
    for (int i = 0; i < 200; ++i) {
      agent->start(std::vector<double>{0.5, 0.5}, random);
      agent->end(fall);
    }
  }
  const auto worst = [](const Agent& agent) {
    return std::min({q(agent, Layer::Negative, 0.1, 0.5, 0), q(agent, Layer::Negative, 0.1, 0.5, 1),
                     q(agent, Layer::Negative, 0.1, 0.5, 2)});
  };
  EXPECT_EQ(worst(*fine), 0.0);
  EXPECT_LT(worst(*coarse), -20.0);
}

TEST(RewardSplit, SendsEveryTermItsWay) {
  RewardSplit split({"goal", "fall", "time"});
  Outcome o;
  o.terms = {200, -100, -1};
  o.reward = 99;
  EXPECT_EQ(split(o).positive, 200);
  EXPECT_EQ(split(o).negative, -101);
  Fields f("split.");
  split.declare(f);
  const auto set = [&](const char* key, double value) {
    for (const auto& field : f.all())
      if (field.parameter.key == key) field.set(value);
  };
  set("split.goal", 3);  // both
  set("split.time", 1);  // positive
  EXPECT_EQ(split(o).positive, 199);
  EXPECT_EQ(split(o).negative, 100);
  set("split.by", 1);  // the sum by its sign
  EXPECT_EQ(split(o).positive, 99);
  EXPECT_EQ(split(o).negative, 0);
  o.terms = {0, -100, -1};
  o.reward = -101;
  EXPECT_EQ(split(o).positive, 0);
  EXPECT_EQ(split(o).negative, -101);
}

TEST(Sarsa2Q, TracesOfTheNegativePartAreNumberedBehindThoseOfThePositive) {
  auto agent = sarsa2q({}, {}, RewardSplit(task().rewardTerms));
  Stream1e5 policy;
  agent->setPolicy(policy);
  Random unused(1);
  agent->start(std::vector{0.1, 0.2}, unused);
  agent->step(Outcome{}, std::vector{0.7, -0.6}, unused);
  std::vector<Eligibility> z;
  agent->eligibility(z);
  ASSERT_FALSE(z.empty());
  const std::uint64_t weights = values({}, 7).weightCount();
  const auto ofNegative = std::count_if(z.begin(), z.end(), [&](const Eligibility& e) { return e.weight >= weights; });
  EXPECT_EQ(2 * static_cast<std::size_t>(ofNegative), z.size()) << "as many as of the positive part";
  for (const Eligibility& e : z) EXPECT_LT(e.weight, 2 * weights);
}

}  // namespace surefoot
