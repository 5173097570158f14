// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/episode_log.h"

#include <gtest/gtest.h>

namespace surefoot {

TEST(EpisodeLog, AveragesTheLastEightyEpisodes) {
  EpisodeLog log;
  for (int i = 1; i <= 100; ++i) {
    log.add({.reward = static_cast<double>(i)});
    log.finish(Ending::Terminal, i);
    if (i == 3) {
      EXPECT_DOUBLE_EQ(log.averageReward(), 2.0);  // those so far
    }
  }
  EXPECT_DOUBLE_EQ(log.averageReward(), (21 + 100) / 2.0);
}

TEST(EpisodeLog, CountsFallsAndSuccessesAndTheirLengths) {
  EpisodeLog log(true);
  log.add({.reward = 0});
  log.add({.reward = -100, .ending = Ending::Terminal, .event = Event::Fall});
  log.finish(Ending::Terminal, 2);
  log.add({.reward = 200, .ending = Ending::Terminal, .event = Event::Success});
  log.finish(Ending::Terminal, 3);
  log.add({.reward = 0});  // cut by the end of the life: not counted
  EXPECT_EQ(log.totals().episodes, 2);
  EXPECT_EQ(log.totals().falls, 1);
  EXPECT_EQ(log.totals().successes, 1);
  EXPECT_EQ(log.totals().failureSteps, 2);
  EXPECT_EQ(log.totals().successSteps, 1);
  ASSERT_EQ(log.rows().size(), 2u);
  EXPECT_EQ(log.rows()[1].lifeSteps, 3);
  EXPECT_DOUBLE_EQ(log.rows()[1].averageReward, 50.0);
}

TEST(EpisodeLog, HashTellsAnyTwoLogsApart) {
  EpisodeLog a, b;
  a.add({.reward = 1.0});
  b.add({.reward = 1.0000000000000002});
  a.finish(Ending::Terminal, 1);
  b.finish(Ending::Terminal, 1);
  EXPECT_NE(a.hash().value(), b.hash().value());
}

}  // namespace surefoot
