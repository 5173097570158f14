// SPDX-License-Identifier: GPL-3.0-or-later
// By hand.
#include "core/findings/measures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot {

namespace {

StoredEpisode success(std::int64_t transitions) {
  return {transitions, 200, 0, EndingCode::Success};
}
StoredEpisode fall(std::int64_t transitions) {
  return {transitions, -100, 1, EndingCode::Fall};
}

ConditionRecord recordOf(std::vector<std::vector<StoredEpisode>> episodes, std::vector<int> qFunctions = {}) {
  ConditionRecord record;
  record.condition.goalReward = 200;
  record.condition.stepTime = 0.6;  // 100 transitions are a minute
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    StoredLife life;
    life.life = static_cast<int>(i);
    life.qFunction = qFunctions.empty() ? -1 : qFunctions[i];
    record.lives.push_back(life);
  }
  record.episodes = std::move(episodes);
  return record;
}

}  // namespace

TEST(Measures, AverageRewardIsOfTheLast80OrOfThoseSoFar) {
  std::vector<StoredEpisode> episodes(200, success(1));
  episodes[0] = episodes[1] = fall(1);
  const auto a = averageRewards(episodes);
  EXPECT_EQ(a[0], -100);
  EXPECT_EQ(a[2], 0);
  EXPECT_EQ(a[79], (78 * 200 - 200) / 80.0);
  EXPECT_EQ(a[80], (79 * 200 - 100) / 80.0);
  EXPECT_EQ(a[81], 200);
}

TEST(Measures, LearningEndsAtTheFirstQuietEpisodeFrom330) {
  EXPECT_EQ(endOfLearning(std::vector<double>(1000, 195), 200), 330u);
  EXPECT_EQ(endOfLearning(std::vector<double>(1000, 150), 200), std::nullopt) << "0.75·200 is not above 0.75·200";
  EXPECT_EQ(endOfLearning(std::vector<double>(329, 195), 200), std::nullopt);
  // 195 from episode 400 on: A(k) − A(k − 250) is below 3 from k − 250 = 400 on.
  std::vector<double> a(1000, 0);
  for (std::size_t k = 400; k <= 1000; ++k) a[k - 1] = 195;
  EXPECT_EQ(endOfLearning(a, 200), 650u);
  EXPECT_EQ(endOfLearning({}, 200), std::nullopt);
}

// The mean of 100 lives lies on a grid of 1.25/100, so that changes of exactly 3 are frequent; they are no end.
TEST(Measures, AChangeOfExactlyThreeIsNotBelowThree) {
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> a(400, (14'000 + i) * 1.25 / 100);
    for (std::size_t k = 330; k <= 400; ++k) a[k - 1] = (14'240 + i) * 1.25 / 100;
    EXPECT_EQ(endOfLearning(a, 200), std::nullopt) << i;
    for (std::size_t k = 330; k <= 400; ++k) a[k - 1] = (14'239 + i) * 1.25 / 100;
    EXPECT_EQ(endOfLearning(a, 200), 330u) << i;
  }
}

TEST(Measures, WithAnotherGoalLearningEndsAtTheSameEpisode) {
  std::vector<double> a(700, 100);
  for (std::size_t k = 300; k <= 700; ++k) a[k - 1] = 190 - 40.0 * std::exp(-static_cast<double>(k) / 150);
  std::vector<double> twice = a;
  for (double& v : twice) v *= 2;
  ASSERT_TRUE(endOfLearning(a, 200));
  EXPECT_EQ(endOfLearning(a, 200), endOfLearning(twice, 400));
}

// Whenever learning ended: falls of the episodes that were over by then.
TEST(Measures, FallsAtFixedMoments) {
  std::vector<StoredEpisode> episodes(340, success(2));
  for (const std::size_t fallen : {10u, 49u, 50u, 329u, 330u}) episodes[fallen] = fall(2);
  ConditionRecord record = recordOf({episodes, {fall(10)}});
  record.lives[0].steps = 680;
  record.lives[1].steps = 10;
  const auto lives = measure(record, std::nullopt);
  EXPECT_EQ(lives[0].fallsByMinute[0], 2) << "episodes 11 and 50 of the 50 in the first 100 transitions";
  EXPECT_EQ(lives[0].fallsByMinute[1], 3);
  EXPECT_EQ(lives[0].fallsByMinute[2], 3);
  EXPECT_EQ(lives[0].fallsByEpisode, 4) << "of the first 330";
  EXPECT_TRUE(std::isnan(lives[1].fallsByMinute[0])) << "it lived for 10 transitions";
  EXPECT_TRUE(std::isnan(lives[1].fallsByEpisode));
}

TEST(Measures, TheLargestChangeBehindTheEnd) {
  std::vector<double> a(1000, 195);
  a[700] = 190;
  EXPECT_EQ(largestChangeAfter(a, 330), 5);
  EXPECT_EQ(largestChangeAfter(a, 960), 0);
}

TEST(Measures, ALifeUpToTheEndOfLearning) {
  const auto record = recordOf({{fall(10), success(40), fall(30), success(20), success(50)}});
  const auto m = measure(record, 3)[0];
  EXPECT_EQ(m.falls, 2);
  EXPECT_DOUBLE_EQ(m.minutes, 0.8);
  EXPECT_EQ(m.allFalls, 2);
  EXPECT_DOUBLE_EQ(m.endPerformance, 2 / 5.0);
  EXPECT_EQ(m.during.success, 40);
  EXPECT_EQ(m.during.failure, 20);
  EXPECT_EQ(m.after.success, 35);
  EXPECT_TRUE(std::isnan(m.after.failure));
  EXPECT_EQ(measure(record, std::nullopt)[0].falls, 2) << "a condition that never ends: the whole life";
  EXPECT_EQ(fallsUntil(record, 1), std::vector<double>{1});
}

TEST(Measures, RewardAgainstFallsKeepsTheLastValueOfALifeWithFewer) {
  const auto record = recordOf({{fall(1), fall(1), success(1)}, {fall(1), success(1), success(1)}});
  const Curve curve = rewardAgainstFalls(record);
  ASSERT_EQ(curve.x, (std::vector<double>{1, 2}));
  EXPECT_EQ(curve.y[0].value, -100);
  EXPECT_EQ(curve.y[1].value, (-100 + 100) / 2.0);  // second life: (−100 + 200 + 200)/3 = 100
}

TEST(Measures, LearningCurveEndsWithTheShortestLife) {
  const auto record = recordOf({{fall(100), success(100)}, {success(100), success(100), success(100)}});
  const Curve curve = learningCurve(record, 3);
  ASSERT_EQ(curve.x, (std::vector<double>{1, 2})) << "nothing is over at 0";
  EXPECT_EQ(curve.y[0].value, (-100 + 200) / 2.0);
  EXPECT_EQ(curve.y[1].value, (50 + 200) / 2.0);
  const Curve falls = cumulativeFalls(record, 3);
  EXPECT_EQ(falls.y[1].value, 0.5);
}

TEST(Measures, LivesOfOneQFunctionStandTogether) {
  const std::vector<double> values = {1, 2, 3, 4};
  EXPECT_EQ(byQFunction(recordOf({{}, {}, {}, {}}, {0, 1, 0, 1}), values), (Groups{{1, 3}, {2, 4}}));
  EXPECT_EQ(byQFunction(recordOf({{}, {}, {}, {}}, {0, 1, 2, 3}), values), (Groups{{1}, {2}, {3}, {4}}));
  EXPECT_EQ(byQFunction(recordOf({{}, {}, {}, {}}, {2, 0, 3, 1}), values), (Groups{{2}, {4}, {1}, {3}}));
  EXPECT_EQ(byQFunction(recordOf({{}, {}, {}, {}}), values), (Groups{{1, 2, 3, 4}})) << "none";
}

}  // namespace surefoot
