// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environments/random_walk.h"
#include "core/register/register.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/experiment/configuration.h"
#include "core/values/eligibility_trace.h"

namespace surefoot {

namespace {

Configuration walkConfiguration(const Registry& r, double stepSize, double lambda) {
  Names names;
  names.environment = "random-walk", names.features = "table", names.policy = "greedy";
  auto c = configure(r, names,
                     {{"agent.step_size", fmt::format("{}", stepSize)},
                      {"agent.trace_decay", fmt::format("{}", lambda)},
                      {"agent.discount", "1"},
                      {"agent.trace", "accumulating"},
                      {"agent.trace_cutoff", "0"},
                      {"features.initial_high", "0"}});
  EXPECT_TRUE(c) << c.error().message;
  return *c;
}

double valueOf(const Life& life, double state) {
  double v = 0.0;
  life.agent().values().evaluate(std::vector<double>{state}, Layer::Sum, std::span(&v, 1));
  return v;
}

/// RMS error over the 19 states after each of the first 10 episodes, averaged over them and over 100 lives.
double rmsError(double stepSize, double lambda) {
  Registry r;
  registerCore(r);
  Configuration c = walkConfiguration(r, stepSize, lambda);
  c.episodes = 10;
  constexpr int kLives = 100;
  double sum = 0.0;
  for (int index = 0; index < kLives; ++index) {
    auto life = makeLife(r, c, index, false);
    EXPECT_TRUE(life) << life.error().message;
    for (int episode = 1; episode <= 10; ++episode) {
      while ((*life)->log().totals().episodes < episode && !(*life)->finished()) (*life)->step();
      double squares = 0.0;
      for (double s = 1; s <= RandomWalk::kStates; ++s)
        squares += std::pow(valueOf(**life, s) - RandomWalk::value(s), 2);
      sum += std::sqrt(squares / RandomWalk::kStates) / 10 / kLives;
    }
  }
  return sum;
}

}  // namespace

TEST(RandomWalk, WalksAStepToEitherSideAndIsPaidAtTheEnds) {
  RandomWalk walk;
  Random random(1);
  int rights = 0, ends = 0;
  for (int episode = 0; episode < 2000; ++episode) {
    walk.reset(random);
    double before = walk.state()[0];
    EXPECT_EQ(before, 10);
    Outcome o;
    while (o.ending == Ending::None) {
      o = walk.step(0);
      ASSERT_EQ(std::abs(walk.state()[0] - before), 1);
      before = walk.state()[0];
    }
    ++ends;
    rights += o.reward > 0;
    EXPECT_EQ(o.reward, before > 10 ? 1 : -1);
  }
  EXPECT_NEAR(rights, ends / 2, 3.5 * std::sqrt(ends) / 2) << "equal chances";
}

// Sutton & Barto 2018, Figure 12.6 (TD(λ), accumulating traces; average RMS error over the 19 states and the first 10
// episodes): the lowest points of the curves. The figure prints no numbers; these are what the published reproduction
// of it computes (github.com/ShangtongZhang/reinforcement-learning-an-introduction, chapter12/random_walk.py at
// 097b4da, its step sizes, 100 runs). Tolerance: twice the standard error of 100 lives, 0.007.
TEST(RandomWalk, TheErrorsAreThoseOfFigure126) {
  struct Reading {
    double lambda, error;
    std::vector<double> alphas;  // around the α of the lowest point
  };
  const Reading readings[] = {{0.0, 0.347, {0.7, 0.8, 0.9}},
                              {0.4, 0.274, {0.6, 0.7, 0.8}},
                              {0.8, 0.265, {0.2, 0.3, 0.4}},
                              {0.9, 0.290, {0.15, 0.2, 0.25}},
                              {1.0, 0.499, {0.01, 0.015, 0.02}}};
  for (const Reading& reading : readings) {
    double best = 10.0;
    for (const double alpha : reading.alphas) best = std::min(best, rmsError(alpha, reading.lambda));
    EXPECT_NEAR(best, reading.error, 0.015) << "λ " << reading.lambda;
  }
  EXPECT_NEAR(rmsError(0.0, 0.5), std::sqrt(2 * 2.85 / 19), 1e-12) << "where every curve begins";
}

// λ = 1, accumulating, no cut-off, the updates of an episode added up and made at its end: the same as Monte Carlo,
// every visit (Sutton & Barto 2018, section 12.1). On walks of the environment, from values that are not 0.
TEST(RandomWalk, LambdaOneOffLineIsMonteCarlo) {
  constexpr double kAlpha = 0.1;
  RandomWalk walk;
  Random random(7);
  for (int episode = 0; episode < 200; ++episode) {
    std::vector<double> v(20), monteCarlo(20, 0.0);
    WeightTable sum(20);
    for (double& value : v) value = random.uniform(-1, 1);
    EligibilityTrace trace;
    std::vector<std::size_t> visited;
    walk.reset(random);
    Outcome outcome;
    while (outcome.ending == Ending::None) {
      const auto s = static_cast<std::size_t>(walk.state()[0]);
      visited.push_back(s);
      outcome = walk.step(0);
      const double next = outcome.ending == Ending::None ? v[static_cast<std::size_t>(walk.state()[0])] : 0.0;
      trace.decay(sum, 1.0, 0.0);
      trace.accumulate(sum, static_cast<Index>(s));
      trace.add(sum, kAlpha * (outcome.reward + next - v[s]));
    }
    for (const std::size_t s : visited) monteCarlo[s] += kAlpha * (outcome.reward - v[s]);
    for (std::size_t s = 1; s < 20; ++s)
      ASSERT_NEAR(sum[s], monteCarlo[s], 1e-12 * static_cast<double>(visited.size()));
  }
}

// The same through a whole life. With a step size of 10⁻⁹ the values stand still within an episode, up to 10⁻¹⁸; what
// is compared is the change divided by it.
TEST(RandomWalk, ALifeWithLambdaOneIsMonteCarlo) {
  constexpr double kAlpha = 1e-9;
  Registry r;
  registerCore(r);
  Configuration c = walkConfiguration(r, kAlpha, 1.0);
  c.episodes = 1;
  for (int index = 0; index < 50; ++index) {
    auto life = makeLife(r, c, index, false);
    ASSERT_TRUE(life);
    std::vector<double> visited;
    while (!(*life)->finished()) {
      visited.push_back((*life)->environment().state()[0]);
      (*life)->step();
    }
    const double g = (*life)->log().last().reward;  // the return of every visit, γ = 1
    std::vector<double> monteCarlo(20, 0.0);
    for (const double s : visited) monteCarlo[static_cast<std::size_t>(s)] += g;  // every visit: G − V(S), V = 0
    for (double s = 1; s <= RandomWalk::kStates; ++s)
      ASSERT_NEAR(valueOf(**life, s) / kAlpha, monteCarlo[static_cast<std::size_t>(s)],
                  1e-6 * (1 + std::abs(monteCarlo[static_cast<std::size_t>(s)])))
          << "life " << index << ", state " << s;
  }
}

}  // namespace surefoot
