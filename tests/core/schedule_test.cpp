// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/schedule.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/policies/softmax.h"

namespace surefoot {

namespace {

/// A schedule from 4 to 1, set up through its declaration, as a configuration would.
Scheduled schedule(double kind, double over, double per) {
  Scheduled scheduled(4.0);
  Fields fields("");
  scheduled.declare(fields, {.key = "v", .title = "V", .low = 0, .high = 10, .help = "."});
  for (const auto& field : fields.all()) {
    if (field.parameter.key == "v_schedule") field.set(kind);
    if (field.parameter.key == "v_end") field.set(1.0);
    if (field.parameter.key == "v_over") field.set(over);
    if (field.parameter.key == "v_per") field.set(per);
  }
  return scheduled;
}

double at(Scheduled scheduled, std::int64_t episodes, std::int64_t steps) {
  scheduled.advance({episodes, steps});
  return scheduled.now();
}

}  // namespace

TEST(Scheduled, ConstantStaysWhateverTimeItIs) {
  EXPECT_EQ(at(schedule(0, 10, 0), 5, 5), 4.0);
  EXPECT_EQ(Scheduled(0.3).now(), 0.3) << "and needs no clock";
}

TEST(Scheduled, AThresholdMayFollowTheRuleOfThumb) {
  Scheduled threshold(50.0);
  Fields fields("");
  threshold.declare(fields, {.key = "v", .title = "V", .low = 0, .high = 100, .help = "."}, true);
  for (const auto& field : fields.all())
    if (field.parameter.key == "v_schedule") {
      ASSERT_EQ(field.parameter.choices.back(), "rule");
      field.set(3.0);
    }
  threshold.advance({0, 0});
  EXPECT_EQ(threshold.now(), 50.0) << "it says nothing yet";
  threshold.advance({7, 70, 62.6});
  EXPECT_EQ(threshold.now(), 62.6);
  EXPECT_FALSE(threshold.everyStep());
}

TEST(Scheduled, LinearReachesItsEndAndStays) {
  const Scheduled s = schedule(1, 10, 0);
  EXPECT_DOUBLE_EQ(at(s, 0, 99), 4.0);
  EXPECT_DOUBLE_EQ(at(s, 5, 99), 2.5);
  EXPECT_DOUBLE_EQ(at(s, 10, 99), 1.0);
  EXPECT_DOUBLE_EQ(at(s, 1000, 99), 1.0);
}

TEST(Scheduled, ExponentialHalvesTheDistanceToItsEnd) {
  const Scheduled s = schedule(2, 10, 0);
  EXPECT_NEAR(at(s, 10, 0), 2.5, 1e-14);
  EXPECT_NEAR(at(s, 20, 0), 1.75, 1e-14);
  EXPECT_NEAR(at(s, 100'000, 0), 1.0, 1e-14);
}

TEST(Scheduled, CountsEpisodesOrSteps) {
  EXPECT_DOUBLE_EQ(at(schedule(1, 10, 1), 0, 5), 2.5);
  EXPECT_TRUE(schedule(1, 10, 1).everyStep());
  EXPECT_FALSE(schedule(1, 10, 0).everyStep());
  EXPECT_FALSE(schedule(0, 10, 1).everyStep()) << "constant";
}

TEST(Scheduled, APolicyFollowsIt) {
  Softmax softmax(Softmax::Settings{schedule(1, 10, 0)});
  const std::vector<double> q = {0, 1};
  std::vector<double> pi(2);
  for (const auto& [episode, temperature] : {std::pair{0, 4.0}, std::pair{5, 2.5}, std::pair{10, 1.0}}) {
    softmax.advance({episode, 0});
    softmax.probabilities({.q = q}, pi);
    EXPECT_NEAR(pi[1] / pi[0], std::exp(1 / temperature), 1e-12);
  }
}

}  // namespace surefoot
