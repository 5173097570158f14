// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/learning_curve.h"

#include <gtest/gtest.h>

namespace surefoot {

TEST(LearningCurve, StaysBoundedAndKeepsItsBeginning) {
  LearningCurve curve;
  for (int i = 1; i <= 1'000'000; ++i) curve.add({.episode = i, .lifeSteps = 10 * i}, i / 3);
  const auto& points = curve.points();
  EXPECT_LE(points.size(), LearningCurve::kMostPoints);
  EXPECT_GE(points.size(), LearningCurve::kMostPoints / 4);
  const auto all = static_cast<std::size_t>(LearningCurve::kAll);
  for (std::size_t i = 0; i < all; ++i) ASSERT_EQ(points[i].episode, static_cast<std::int64_t>(i) + 1);
  const auto spacing = points[all + 1].episode - points[all].episode;
  for (std::size_t i = all + 1; i < points.size(); ++i)
    ASSERT_EQ(points[i].episode - points[i - 1].episode, spacing) << "even behind it";
}

// The rule by hand: a constant average of 160 is above 0.75·200 and does not move; the first episode that counts is
// 330.
TEST(EndOfLearning, IsNotBeforeEpisode330) {
  EndOfLearning end;
  for (int i = 1; i <= 400; ++i) end.add(i, 160, 50 * i, 200);
  EXPECT_EQ(end.episode(), 330);
  EXPECT_EQ(end.lifeSteps(), 50 * 330);
}

TEST(EndOfLearning, AFlatStartDoesNotCount) {
  EndOfLearning end;
  for (int i = 1; i <= 1000; ++i) end.add(i, -100, 50 * i, 200);
  EXPECT_EQ(end.episode(), 0);
}

// A ramp of 0.012 an episode moves by exactly 3 in 250: not below 3. At half of it the rule holds as soon as the
// average is above 150.
TEST(EndOfLearning, ComparesWith250EpisodesBefore) {
  EndOfLearning steep, gentle;
  for (int i = 1; i <= 900; ++i) {
    steep.add(i, 160 + 0.0121 * i, i, 200);
    gentle.add(i, 147 + 0.006 * i, i, 200);
  }
  EXPECT_EQ(steep.episode(), 0);
  EXPECT_EQ(gentle.episode(), 501);
}

}  // namespace surefoot
