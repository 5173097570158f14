// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/findings/uncertain_end.h"

#include <gtest/gtest.h>

#include "core/findings/evidence.h"

namespace surefoot {

namespace {

constexpr double kEndGoal = 200;

/// Lives that fall less and less often, sooner or later: the share of falls halves every `halves` episodes.
Evidence conditionOf(std::size_t lives, int episodes, Random& random) {
  Evidence e;
  e.record.condition.goalReward = kEndGoal;
  e.record.condition.stepTime = 0.6;
  for (std::size_t l = 0; l < lives; ++l) {
    const double halves = 60 * (0.6 + 0.8 * random.uniform());
    auto& life = e.record.episodes.emplace_back();
    for (int k = 0; k < episodes; ++k) {
      const bool fall = random.uniform() < 0.6 * std::exp2(-k / halves) + 0.01;
      life.push_back({50, fall ? -100.0 : kEndGoal, fall, fall ? EndingCode::Fall : EndingCode::Success});
    }
    StoredLife stored;
    stored.life = static_cast<int>(l);
    e.record.lives.push_back(stored);
  }
  e.averages = meanAverageRewards(e.record);
  e.end = endOfLearning(e.averages, kEndGoal);
  e.lives = measure(e.record, e.end);
  e.untilOtherEnds = resampledUntilEnd(e.record, e.end);
  return e;
}

}  // namespace

TEST(UncertainEnd, ResamplesAreMeasuredUpToEndsOfTheirOwn) {
  Random random(1);
  const Evidence e = conditionOf(10, 700, random);
  ASSERT_TRUE(e.end);
  const auto& minutes = e.untilOtherEnds.at("minutes");
  EXPECT_GT(*std::max_element(minutes.begin(), minutes.end()), *std::min_element(minutes.begin(), minutes.end()) + 10);
  EXPECT_EQ(e.untilOtherEnds, resampledUntilEnd(e.record, e.end)) << "always the same";
  // 50 transitions of 0.6 s are half a minute, the same in every life: only the end varies.
  EXPECT_EQ(varianceOf(valuesOf(e, "minutes")), 0);
  EXPECT_GT(meanOf(e, "minutes").high, meanOf(e, "minutes").value + 5);
}

TEST(UncertainEnd, WhereNothingVariesStudentsIntervalStays) {
  Random random(1);
  const Evidence never = conditionOf(10, 300, random);
  EXPECT_FALSE(never.end);
  EXPECT_TRUE(never.untilOtherEnds.empty()) << "too short to end at all";
  EXPECT_NEAR(meanOf(never, "falls").high, meanInterval(valuesOf(never, "falls"))->high, 1e-9);
  EXPECT_TRUE(conditionOf(1, 700, random).untilOtherEnds.empty()) << "one life";
}

// Two conditions alike, 400 times: a standard error of 1 %. Bounds of three of them beside 92 and 98 %.
TEST(UncertainEnd, TheIntervalOfTheLearningTimeHolds) {
  constexpr int kExperiments = 400;
  Random random(7);
  int held = 0, heldFalls = 0, heldWithoutIt = 0;
  for (int i = 0; i < kExperiments; ++i) {
    Evidence a = conditionOf(5, 600, random), b = conditionOf(5, 600, random);
    const auto holds = [&](const char* measure) {
      const Interval d = differenceOf(estimateOf(a, measure), estimateOf(b, measure), false);
      return d.low <= 0 && d.high >= 0;
    };
    held += holds("minutes"), heldFalls += holds("falls");
    a.untilOtherEnds.clear(), b.untilOtherEnds.clear();
    heldWithoutIt += holds("minutes");
  }
  EXPECT_GT(held, 0.89 * kExperiments);
  EXPECT_GT(heldFalls, 0.89 * kExperiments);
  EXPECT_LT(heldWithoutIt, 0.6 * kExperiments) << "the end taken for certain";
}

}  // namespace surefoot
