// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/caution.h"

#include <gtest/gtest.h>

#include <set>

#include "core/policies/epsilon_greedy.h"
#include "core/policies/greedy.h"
#include "core/policies/softmax.h"
#include "core/policies/threshold_restricted.h"

namespace surefoot {

namespace {

using Row = std::vector<double>;

template <class P>
P with(std::initializer_list<std::pair<const char*, double>> settings, P policy = {}) {
  Fields f("");
  policy.declare(f);
  for (const auto& [key, value] : settings)
    for (const auto& field : f.all())
      if (field.parameter.key == key) field.set(value);
  return policy;
}

double rule(CautionRule r) {
  return static_cast<double>(r);
}

Row probabilities(const Policy& policy, const ActionView& view) {
  Row pi(view.q.size());
  policy.probabilities(view, pi);
  return pi;
}

const Row kQ = {73, 17, 33, 69, 7}, kRisk = {0.004, 0.018, 0.061, 0.21, 0.48};

}  // namespace

TEST(Caution, OffOrWithoutRiskItChangesNothing) {
  for (const CautionRule r : {CautionRule::Weight, CautionRule::Filter, CautionRule::Explore, CautionRule::Losses})
    EXPECT_EQ(probabilities(with<Softmax>({{"risk", rule(r)}}), {.q = kQ}), probabilities(Softmax(), {.q = kQ}));
  EXPECT_EQ(probabilities(Softmax(), {kQ, kRisk}), probabilities(Softmax(), {.q = kQ}));
}

TEST(Caution, WeightTakesRiskOffTheValues) {
  const auto policy = with<Softmax>({{"risk", rule(CautionRule::Weight)}, {"risk_weight", 100}});
  Row lower = kQ;
  for (std::size_t a = 0; a < lower.size(); ++a) lower[a] -= 100 * kRisk[a];
  EXPECT_EQ(probabilities(policy, {kQ, kRisk}), probabilities(Softmax(), {.q = lower}));
}

TEST(Caution, LossesCountSoManyTimes) {
  const Row losses = {-1, -2, -3, -40, -50};
  const auto policy = with<Softmax>({{"risk", rule(CautionRule::Losses)}, {"losses_factor", 8}});
  Row lower = kQ;
  for (std::size_t a = 0; a < lower.size(); ++a) lower[a] += 7 * losses[a];
  EXPECT_EQ(probabilities(policy, {kQ, {}, losses}), probabilities(Softmax(), {.q = lower}));
}

// The allowed actions are chosen among as if there were no others: ε-greedy explores them all, and TRL's threshold
// parts them alone.
TEST(Caution, FilterChoosesAmongTheAllowed) {
  const auto filtered = [](auto policy) {
    return with({{"risk", rule(CautionRule::Filter)}, {"risk_limit", 0.1}}, policy);
  };
  const ActionView view{kQ, kRisk};
  const Row allowed = {73, 17, 33};
  const auto expect = [&](const auto& policy) {
    Row pi = probabilities(policy, {.q = allowed});
    pi.insert(pi.end(), {0, 0});
    EXPECT_EQ(probabilities(filtered(policy), view), pi);
  };
  expect(EpsilonGreedy());
  expect(Softmax({.temperature = 20.0}));
  expect(with<ThresholdRestricted>({{"threshold", 20}}));
  expect(Greedy());
}

TEST(Caution, WhereNothingIsBelowTheLimitTheLeastRiskyAreTaken) {
  const Row risk = {0.3, 0.2, 0.5, 0.2, 0.9};
  const auto policy = with<EpsilonGreedy>({{"risk", rule(CautionRule::Filter)}, {"epsilon", 0.2}});
  EXPECT_EQ(probabilities(policy, {kQ, risk}), (Row{0, 0.1, 0, 0.9, 0}));
}

// "TRL on risk": the greedy action stays, however risky it is.
TEST(Caution, ExploreRestrictsExploringStepsAlone) {
  const Row risk = {0.9, 0.01, 0.5, 0.01, 0.9};
  const auto policy = with<EpsilonGreedy>({{"risk", rule(CautionRule::Explore)}, {"epsilon", 0.3}});
  const Row pi = probabilities(policy, {kQ, risk});
  EXPECT_DOUBLE_EQ(pi[0], 0.7 + 0.1);
  EXPECT_DOUBLE_EQ(pi[1], 0.1);
  EXPECT_DOUBLE_EQ(pi[3], 0.1);
  EXPECT_EQ(pi[2], 0);
  EXPECT_EQ(pi[4], 0);
}

TEST(Caution, TheGreedyPolicyAndWhatExploresFollowTheRule) {
  const auto policy = with<EpsilonGreedy>({{"risk", rule(CautionRule::Filter)}, {"risk_limit", 0.1}});
  const Row risk = {0.5, 0.02, 0.03, 0.2, 0.01};
  const ActionView view{kQ, risk};
  Row pi(5);
  policy.greedy(view, pi);
  EXPECT_EQ(pi, (Row{0, 0, 1, 0, 0}));
  const auto exploring = [&](const Policy& drawn) {  // the actions whose draws count as exploring
    Random random(1);
    std::set<Action> actions;
    for (int i = 0; i < 2000; ++i)
      if (const auto d = drawn.draw(view, pi, random); d.explores) actions.insert(d.action);
    return actions;
  };
  EXPECT_EQ(exploring(policy), (std::set<Action>{1, 4})) << "among the allowed, 2 is the best";
  EXPECT_EQ(exploring(EpsilonGreedy()), (std::set<Action>{1, 2, 3, 4})) << "0 is the best";
}

}  // namespace surefoot
