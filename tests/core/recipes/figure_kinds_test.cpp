// SPDX-License-Identifier: GPL-3.0-or-later
// The profile and the frontier of lives made by hand.
#include "core/recipes/figure.h"
#include "tests/core/recipes/claim_evidence.h"

namespace surefoot {

TEST(FigureKinds, AProfileIsTheShareOfLivesWithAtMostSoManyFalls) {
  const std::vector<Evidence> one = {condition("a", 30)};  // 20 lives, four at each of five numbers of falls
  const auto figure = makeFigure(kRegistry, {.name = "p", .title = "", .kind = "profile"}, one);
  ASSERT_TRUE(figure) << figure.error().message;
  const FigureSeries& s = figure->series.at(0);
  ASSERT_EQ(s.x.size(), 10u) << "two points a step";
  EXPECT_EQ(s.x[0], s.x[1]);
  EXPECT_EQ(s.y[0].value, 0);
  EXPECT_DOUBLE_EQ(s.y[1].value, 0.2);
  EXPECT_DOUBLE_EQ(s.y[2].value, 0.2);
  EXPECT_DOUBLE_EQ(s.y.back().value, 1);
  EXPECT_LE(s.y[9].high, 1);
}

TEST(FigureKinds, AFrontierHasAPointForEachConditionWithBothIntervals) {
  const std::vector<Evidence> two = {condition("a", 30), condition("b", 60, "a")};
  const auto figure = makeFigure(kRegistry, {.name = "f", .title = "", .kind = "frontier", .measure = "minutes"}, two);
  ASSERT_TRUE(figure) << figure.error().message;
  EXPECT_TRUE(figure->points);
  ASSERT_EQ(figure->series.size(), 2u);
  EXPECT_NEAR(figure->series[1].x[0], 60, 1e-9);
  EXPECT_NEAR(figure->series[1].y[0].value, 1.2, 1e-9);
  EXPECT_LT(figure->series[1].spread[0].low, 60);
  EXPECT_NE(figureAsCsv(*figure).find("b,60,1.2"), std::string::npos);
  EXPECT_FALSE(makeFigure(kRegistry, {.name = "f", .title = "", .kind = "frontier", .measure = "fals"}, two));
}

}  // namespace surefoot
