// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/lessons/equal_share.h"
#include "core/lessons/handed_in/class_table.h"
#include "core/lessons/verdict.h"
#include "tests/core/lessons/taught.h"

namespace surefoot {

TEST(ClassTable, SaysWhatEveryStudentSaidAndWhatMostSay) {
  std::vector<HandIn> handIns;
  for (const char* student : {"Cleo", "Ada", "Bob"}) {
    auto handIn = parseHandIn(handedIn(student, std::string(student) != "Ada"));
    ASSERT_TRUE(handIn);
    handIns.push_back(std::move(*handIn));
  }
  HandIn other = handIns[0];
  other.lesson = "another";
  handIns.push_back(other);
  const ClassTable table = classTableOf(taught(), handIns);
  EXPECT_EQ(table.students, (std::vector<std::string>{"Ada", "Bob", "Cleo"}));
  EXPECT_EQ(table.cells[0][0].text, "40") << "a prediction";
  EXPECT_EQ(table.cells[0][1].state, ClassCell::State::Right);
  EXPECT_EQ(table.cells[1][1].state, ClassCell::State::Wrong) << "the first answer is the telling one";
  EXPECT_EQ(table.cells[2][3].text, "done");
  EXPECT_EQ(table.steps[0].mostSay, "half of them say 40 to 40");
  EXPECT_EQ(table.steps[1].mostSay, "2 of 3 said first: x");
  EXPECT_EQ(table.steps[1].right, 1);
  EXPECT_TRUE(classTableOf(taught(), {}).students.empty());
}

TEST(EqualShare, IsThatOfBothPolicies) {
  EXPECT_DOUBLE_EQ(epsilonFor(0.1, 5), 0.125);
  EXPECT_DOUBLE_EQ(epsilonFor(0.9, 2), 1.0) << "more than all the time cannot be";
  EXPECT_DOUBLE_EQ(epsilonFor(0.3, 1), 0.0);
  const std::vector<ShareOfTemperature> rows = {{1, 0.1}, {2, 0.2}, {4, 0.4}};
  EXPECT_DOUBLE_EQ(temperatureFor(0, rows), 0);
  EXPECT_DOUBLE_EQ(temperatureFor(0.2, rows), 2);
  EXPECT_NEAR(temperatureFor(0.15, rows), std::sqrt(2.0), 1e-9);
  EXPECT_DOUBLE_EQ(temperatureFor(0.9, rows), 4) << "as often as it can";
  EXPECT_DOUBLE_EQ(temperatureFor(0.5, {}), 0);
  Configuration c = taught().start;
  const auto measured = sharesOfSoftmax(registryOfCore(), c, 50);
  ASSERT_EQ(measured.size(), 11u);
  for (std::size_t i = 1; i < measured.size(); ++i) EXPECT_GE(measured[i].share, measured[i - 1].share);
  EXPECT_GT(measured.back().share, 0.5) << "hot: any of four actions";
}

TEST(Comparing, IsByTheIntervalOfTheMeanDifference) {
  const std::vector<double> low = {1, 2, 3, 2, 1}, high = {11, 13, 12, 12, 10}, wide = {0, 9, 2, 1, 3};
  EXPECT_EQ(compare(low, high).answer, Compared::First);
  EXPECT_EQ(compare(high, low).answer, Compared::Second);
  EXPECT_EQ(compare(low, wide).answer, Compared::CannotTell);
  EXPECT_TRUE(judge(compare(low, wide), Compared::CannotTell).right);
  EXPECT_FALSE(judge(compare(low, high), Compared::CannotTell).right);
  EXPECT_NE(judge(compare(low, high), Compared::First).remark.find("0 is not in it"), std::string::npos);
  EXPECT_EQ(compare({}, {}).answer, Compared::CannotTell);
}

}  // namespace surefoot
