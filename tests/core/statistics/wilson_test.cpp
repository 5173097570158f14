// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/wilson.h"

#include <gtest/gtest.h>

namespace surefoot {

// Newcombe (1998), Statistics in Medicine 17, table I, method 3: four places are given.
TEST(Wilson, GivesThePublishedIntervals) {
  const struct {
    std::int64_t count, trials;
    double low, high;
  } published[] = {{81, 263, 0.2553, 0.3662}, {15, 148, 0.0624, 0.1605}, {0, 20, 0.0, 0.1611}, {1, 29, 0.0061, 0.1718}};
  for (const auto& p : published) {
    const Interval interval = wilsonInterval(p.count, p.trials);
    EXPECT_DOUBLE_EQ(interval.value, static_cast<double>(p.count) / static_cast<double>(p.trials));
    EXPECT_NEAR(interval.low, p.low, 5e-5) << p.count << " of " << p.trials;
    EXPECT_NEAR(interval.high, p.high, 5e-5) << p.count << " of " << p.trials;
  }
}

// Its ends are the shares from which the observed one is just 1.96 standard errors away.
TEST(Wilson, ItsEndsAreWhereTheScoreTestDecides) {
  for (const std::int64_t count : {1, 7, 50, 99}) {
    const Interval interval = wilsonInterval(count, 100);
    for (const double end : {interval.low, interval.high})
      EXPECT_NEAR(std::abs(interval.value - end) / std::sqrt(end * (1 - end) / 100), 1.959963984540054, 1e-9);
  }
}

TEST(Wilson, IsMirroredAndStaysWithinAllShares) {
  for (const std::int64_t trials : {1, 3, 100, 1'000'000}) {
    const Interval none = wilsonInterval(0, trials), all = wilsonInterval(trials, trials);
    EXPECT_EQ(none.low, 0.0);
    EXPECT_GT(none.high, 0.0);
    EXPECT_EQ(all.high, 1.0);
    EXPECT_NEAR(none.high, 1 - all.low, 1e-12);
  }
  EXPECT_FALSE(wilsonInterval(0, 0).known());
}

}  // namespace surefoot
