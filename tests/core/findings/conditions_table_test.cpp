// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/findings/conditions_table.h"

#include <gtest/gtest.h>

namespace surefoot {

namespace {

/// Four lives of a condition, of which the last fell in most of its greedy tests.
Evidence evidenceOf(const std::string& name, const std::vector<double>& falls, bool robot) {
  Evidence e;
  e.record.condition.name = name;
  e.record.condition.reference = "a";
  e.record.condition.lives = static_cast<int>(falls.size());
  for (const double f : falls) {
    LifeMeasures life;
    life.falls = f;
    life.fallsByMinute = {10, 20, falls[0] == 90 ? 40.0 : 30.0};
    const double last = e.lives.size() + 1 == falls.size() ? 0.6 : 0.5;
    if (robot) life.own = {{0, "greedy_distance", 2.1}, {0, "greedy_falls", last}, {0, "distance", 700}};
    e.lives.push_back(life);
  }
  e.configuration = nlohmann::json::object();
  if (robot) e.taskMeasures = {{"distance", "distance", "m"}};
  e.record.lives.resize(falls.size());
  e.record.episodes.resize(falls.size());
  return e;
}

}  // namespace

// t₃(.975) = 3.182; the standard deviation of the falls is √(200/3), so the mean is known to ±13.0.
TEST(ConditionsTable, HasFallsTheirChangeAndWhatIsAskedFor) {
  const std::vector<Evidence> evidence = {evidenceOf("a", {90, 100, 110, 100}, false),
                                          evidenceOf("b", {40, 50, 60, 50}, true)};
  StoredPlan plan;
  for (const Evidence& e : evidence) plan.conditions.push_back(e.record.condition);
  const ConditionsTable t =
      conditionsTable(findingsOf(plan, evidence), evidence, {"distance", "greedy_distance", "walks"});
  const std::vector<std::string> heads = {"condition",
                                          "lives",
                                          "falls by minute 6",
                                          "change, % (95 %)",
                                          "falls during learning",
                                          "change, % (95 %)",
                                          "p",
                                          "distance of a life [m]",
                                          "distance of a greedy test, last 10 [m]",
                                          "lives that walk"};
  EXPECT_EQ(t.heads, heads);
  ASSERT_EQ(t.rows.size(), 2u);
  EXPECT_EQ(t.rows[0],
            (std::vector<std::string>{"a", "4", "40.0 ± 0.0", "", "100 ± 13, cut off", "", "", "–", "–", "–"}));
  ASSERT_EQ(t.rows[1].size(), heads.size());
  EXPECT_EQ(t.rows[1][2], "30.0 ± 0.0");
  EXPECT_EQ(t.rows[1][4], "50.0 ± 13.0, cut off");
  EXPECT_EQ(t.rows[1][5].substr(0, 5), "-50 (");
  EXPECT_EQ(t.rows[1][6].back(), 'X') << "F = 75 with 1 and 6 degrees of freedom";
  EXPECT_EQ(t.rows[1][7], "700 ± 0");
  EXPECT_EQ(t.rows[1][9], "3 of 4");
}

}  // namespace surefoot
