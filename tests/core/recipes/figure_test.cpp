// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recipes/figure.h"

#include <set>

#include "core/experiment/configuration_json.h"
#include "core/plans/plan.h"
#include "core/recipes/same_stream.h"
#include "core/recipes/thesis_marks.h"
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
    const auto made = makeFigure(registry, spec, evidence);
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
  EXPECT_FALSE(makeFigure(registry, s, evidence));
}

TEST_F(FigureTest, TheThesissNumbersStandBesideOurs) {
  auto evidence = evidenceOf(
      "lives = 2\nreference = \"a\"\n[[condition]]\nname = \"a\"\nminutes = 1\n"
      "[[condition]]\nname = \"b\"\nminutes = 2\n[[condition]]\nname = \"c\"\nminutes = 3\n");
  for (Evidence& e : evidence) e.lives.assign(2, {}), e.record.lives.assign(2, {});
  evidence[0].lives[0].falls = 100, evidence[0].lives[1].falls = 300;
  Figure f = figure(spec("bars"), evidence);
  const auto claim = [](const char* kind, const char* of, double thesis) {
    return Claim{"X", kind, "", {{"thesis", thesis}, {"conditions", {of}}}};
  };
  markThesis(f, "falls", {claim("value", "a", 290), claim("reduction", "b", -45), claim("lowest", "c", 7)}, evidence);
  EXPECT_EQ(f.series[0].thesis, 290);
  EXPECT_NEAR(f.series[1].thesis.value_or(0), 110, 1e-9) << "45 % fewer than our reference's 200";
  EXPECT_FALSE(f.series[2].thesis);
  EXPECT_NE(figureAsCsv(f).find("series,bar,value,low,high,thesis\n"), std::string::npos);
  EXPECT_NE(figureAsCsv(f).find(",290\n"), std::string::npos);
  Figure other = figure(spec("bars"), evidence);
  markThesis(other, "minutes", {claim("value", "a", 290)}, evidence);
  EXPECT_FALSE(other.series[0].thesis) << "a claim about falls says nothing of minutes";
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
  EXPECT_FALSE(makeFigure(registry, s, evidence));
}

TEST_F(FigureTest, ThreeTilingsTellThreeTimesAsManyValuesApart) {  // thesis, Figure 6.3, eq. 6.7
  const auto valuesWith = [&](int tilings) {
    const auto evidence = evidenceOf(
        "[[condition]]\nenvironment = \"mountain-car\"\nepisodes = 1\n"
        "set.features.position = 5\nset.features.velocity = 1\nset.features.tilings = " +
        std::to_string(tilings) + "\n");
    FigureSpec s = spec("values");
    s.state = {0, 0};
    std::set<double> values;
    const Figure f = figure(s, evidence);
    for (const Interval& y : f.series[0].y) values.insert(y.value);
    return values.size();
  };
  EXPECT_NEAR(static_cast<double>(valuesWith(1)), 5, 1) << "an edge of a tile may lie within the range";
  EXPECT_NEAR(static_cast<double>(valuesWith(3)), 15, 1);
}

TEST_F(FigureTest, ATilingHasOneTileForAState) {  // thesis, Figure 2.2
  const auto evidence = evidenceOf(
      "[[condition]]\nenvironment = \"mountain-car\"\nepisodes = 1\n"
      "set.features.tilings = 4\nset.features.position = 3\nset.features.velocity = 2\n");
  FigureSpec s = spec("tilings");
  s.state = {-0.3, 0.01};
  const Figure f = figure(s, evidence);
  ASSERT_TRUE(f.scene);
  // In tiles: the range of the position is 1.7 for 3 of them, that of the velocity 0.14 for 2.
  const double x = -0.3 / 1.7 * 3, y = 0.01 / 0.14 * 2;
  int tiles = 0;
  for (const Shape& shape : f.scene->shapes) {
    const auto* tile = std::get_if<Polygon>(&shape);
    if (!tile || tile->width == 0) continue;
    ++tiles;
    EXPECT_TRUE(tile->points[0].x <= x && x < tile->points[2].x) << tile->points[0].x << " " << x;
    EXPECT_TRUE(tile->points[0].y <= y && y < tile->points[2].y) << tile->points[0].y << " " << y;
  }
  EXPECT_EQ(tiles, 4);
  EXPECT_NE(figureAsCsv(f).find("polygon"), std::string::npos);
  EXPECT_FALSE(makeFigure(registry, s, evidenceOf("[[condition]]\nminutes = 1\n"))) << "three state variables";
}

TEST_F(FigureTest, AWorldIsDrawnUnderTorque) {  // thesis, Figure 3.1
  const Figure f = figure(spec("world"), evidenceOf("[[condition]]\nminutes = 1\n"));
  ASSERT_TRUE(f.scene);
  EXPECT_NE(f.xTitle.find("1.50 N m"), std::string::npos) << f.xTitle;
}

TEST_F(FigureTest, EqualRepresentationsAreTaughtTheSame) {  // thesis, section 6.1.2
  const auto evidence = evidenceOf(
      "[base]\nminutes = 1\nset.features.initial_high = 0\n[[condition]]\nname = \"a\"\n[[condition]]\nname = "
      "\"b\"\nagent = \"sarsa-2q\"\n"
      "[[condition]]\nset.features.tilings = 8\n");
  const auto differ = [&](std::size_t a, std::size_t b) {
    const auto first = configurationFromJson(registry, evidence[a].configuration, "a");
    const auto second = configurationFromJson(registry, evidence[b].configuration, "b");
    return *largestDifference(registry, *first, *second, 20'000);
  };
  EXPECT_LT(differ(0, 1), 1e-9);
  EXPECT_GT(differ(0, 2), 1.0);
}

TEST_F(FigureTest, WhatDoesNotFitIsNamed) {
  const auto evidence = evidenceOf("[[condition]]\nminutes = 1\n");
  FigureSpec s = spec("bars");
  s.measure = "luck";
  EXPECT_NE(makeFigure(registry, s, evidence).error().message.find("luck"), std::string::npos);
  s = spec("against");
  s.along = "policy.luck";
  EXPECT_NE(makeFigure(registry, s, evidence).error().message.find("policy.luck"), std::string::npos);
  s.conditions = {"nobody"};
  EXPECT_NE(makeFigure(registry, s, evidence).error().message.find("no condition"), std::string::npos);
}

TEST_F(FigureTest, CsvHasARowAPointAndQuotesNames) {
  Figure f;
  f.series.push_back({"a \"b\", c", "trl", {1, 2}, {{1, 0, 2}, {3, 2, 4}}, {}});
  EXPECT_EQ(figureAsCsv(f), "series,x,value,low,high\n\"a \"\"b\"\", c\",1,1,0,2\n\"a \"\"b\"\", c\",2,3,2,4\n");
}

}  // namespace surefoot
