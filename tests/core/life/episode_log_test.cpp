// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/episode_log.h"
#include "core/life/life_measures.h"

#include <gtest/gtest.h>

#include <cmath>

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

// What a measure is for a whole life stands where it is declared.
TEST(EpisodeLog, AMeasureOfALifeIsASumAMeanTheLastOrTheLargest) {
  using OfALife = TaskMeasure::OfALife;
  const std::vector<TaskMeasure> measures = {{"way", "way", "m", OfALife::Sum},
                                             {"torque", "torque", "N m", OfALife::Mean},
                                             {"height", "height", "m", OfALife::Last},
                                             {"tilt", "tilt", "rad", OfALife::Largest}};
  EpisodeLog log(false, measures);
  const auto ofALife = [&](std::size_t m) {
    return valueOfALife(measures[m], log.totals().measures[m], log.totals().episodes);
  };
  EXPECT_EQ(ofALife(0), 0.0);
  for (const std::size_t m : {1u, 2u, 3u}) EXPECT_TRUE(std::isnan(ofALife(m))) << "no episode yet";
  const double episodes[][4] = {{1, 2, 3, -5}, {10, 4, 1, -2}, {100, 9, 2, -3}};
  for (const auto& episode : episodes) log.finish(Ending::Terminal, 1, kInfinity, episode);
  EXPECT_EQ(ofALife(0), 111.0);
  EXPECT_EQ(ofALife(1), 5.0);
  EXPECT_EQ(ofALife(2), 2.0);
  EXPECT_EQ(ofALife(3), -2.0) << "of three below 0, the largest";
}

TEST(LifeMeasures, EveryMeasureOfATaskHasItsNamesAndTitles) {
  EXPECT_TRUE(lifeMeasures({}).empty());
  std::vector<std::string> titles;
  for (const LifeMeasure& m : lifeMeasures({{"torque", "torque", "N m", TaskMeasure::OfALife::Mean}}))
    titles.push_back(m.name + ": " + m.titleWithUnit());
  EXPECT_EQ(titles, (std::vector<std::string>{"falls_per_hour: falls an hour", "torque: mean torque of a life [N m]",
                                              "greedy_torque: torque of a greedy test, last 10 [N m]",
                                              "greedy_reward: reward of a greedy test, last 10",
                                              "greedy_falls: falls of a greedy test, last 10"}));
}

}  // namespace surefoot
