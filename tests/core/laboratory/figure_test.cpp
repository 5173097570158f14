// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/figure.h"

#include "core/laboratory/plan.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

class FigureTest : public testing::Test {
 protected:
  /// Conditions without lives.
  std::vector<Evidence> evidenceOf(const std::string& plan) {
    const auto made = parsePlan(registry, plan, "plan.toml", {});
    EXPECT_TRUE(made) << made.error().message;
    std::vector<Evidence> all;
    const auto stored = planToStore(registry, *made);
    for (const StoredCondition& c : stored->conditions) {
      Evidence e;
      e.record.condition = c;
      e.configuration = nlohmann::json::parse(c.configuration);
      e.lives.push_back({});
      all.push_back(std::move(e));
    }
    return all;
  }
  Figure figure(const FigureSpec& spec, const std::vector<Evidence>& evidence) {
    const auto made = makeFigure(registry, spec, evidence, 1);
    EXPECT_TRUE(made) << made.error().message;
    return made ? *made : Figure{};
  }
  Registry registry = fullRegistry();
};

FigureSpec spec(const std::string& kind) {
  FigureSpec s;
  s.name = "f", s.kind = kind;
  return s;
}

}  // namespace

TEST_F(FigureTest, AnUpdateOfState5ReachesItsNeighboursByThirds) {  // thesis, Figure 4.2
  const auto evidence = evidenceOf("[[condition]]\nenvironment = \"chain\"\nepisodes = 1\nset.features.tilings = 3\n");
  FigureSpec s = spec("generalisation");
  s.state = {5};
  const Figure f = figure(s, evidence);
  ASSERT_EQ(f.series.size(), 1u);
  const std::vector<double> thirds = {0, 0, 1, 2, 3, 2, 1, 0, 0, 0};
  ASSERT_EQ(f.series[0].x.size(), thirds.size());
  for (std::size_t i = 0; i < thirds.size(); ++i) EXPECT_NEAR(f.series[0].y[i].value, thirds[i] / 3, 1e-12) << i + 1;
  s.state = {5, 5};
  EXPECT_FALSE(makeFigure(registry, s, evidence, 1));
}

TEST_F(FigureTest, PoliciesFollowTheirFormulasOnABell) {  // thesis, eq. 2.2, 2.3, Algorithm 1, Figure 4.1
  const auto evidence = evidenceOf(
      "[base]\nminutes = 1\n[[condition]]\nset.policy.epsilon = 0.3\n"
      "[[condition]]\npolicy = \"trl\"\nset.policy.threshold = 4\nset.policy.epsilon = 0.3\n"
      "[[condition]]\npolicy = \"softmax\"\nset.policy.temperature = 2\n");
  FigureSpec s = spec("probabilities");
  s.q = {0, 5, 10, 5, 0};
  const Figure f = figure(s, evidence);
  ASSERT_EQ(f.series.size(), 3u);
  const double z = 2 * std::exp(-5.0) + 2 * std::exp(-2.5) + 1;
  const std::vector<std::vector<double>> expected = {
      {0.06, 0.06, 0.76, 0.06, 0.06},
      {0.3 * 0.01 / 2, 0.3 * 0.99 / 3, 0.7 + 0.3 * 0.99 / 3, 0.3 * 0.99 / 3, 0.3 * 0.01 / 2},
      {std::exp(-5.0) / z, std::exp(-2.5) / z, 1 / z, std::exp(-2.5) / z, std::exp(-5.0) / z}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t a = 0; a < 5; ++a) EXPECT_NEAR(f.series[i].y[a].value, expected[i][a], 1e-12) << i << a;
  s.q.clear();
  EXPECT_FALSE(makeFigure(registry, s, evidence, 1));
}

TEST_F(FigureTest, WhatDoesNotFitIsNamed) {
  const auto evidence = evidenceOf("[[condition]]\nminutes = 1\n");
  FigureSpec s = spec("bars");
  s.measure = "luck";
  EXPECT_NE(makeFigure(registry, s, evidence, 1).error().message.find("luck"), std::string::npos);
  s = spec("against");
  s.along = "policy.luck";
  EXPECT_NE(makeFigure(registry, s, evidence, 1).error().message.find("policy.luck"), std::string::npos);
  s.conditions = {"nobody"};
  EXPECT_NE(makeFigure(registry, s, evidence, 1).error().message.find("no condition"), std::string::npos);
}

TEST_F(FigureTest, CsvHasARowAPointAndQuotesNames) {
  Figure f;
  f.series.push_back({"a \"b\", c", "trl", {1, 2}, {{1, 0, 2}, {3, 2, 4}}, {}});
  EXPECT_EQ(figureAsCsv(f), "series,x,value,low,high\n\"a \"\"b\"\", c\",1,1,0,2\n\"a \"\"b\"\", c\",2,3,2,4\n");
}

}  // namespace surefoot
