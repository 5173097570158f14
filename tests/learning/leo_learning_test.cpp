// SPDX-License-Identifier: GPL-3.0-or-later
// LEO learns to walk, twenty lives of two simulated hours: labelled slow.
#include <gtest/gtest.h>

#include "core/experiment/experiment.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

TEST(LeoLearning, AtLeastSixteenOfTwentyLivesLearnToWalkWithinTwoHours) {
  const Registry registry = fullRegistry();
  Names names;
  names.environment = "leo";
  auto c = configure(registry, names, {});
  ASSERT_TRUE(c) << c.error().message;
  c->seed = 1;
  c->lives = 20;
  c->minutes = 120;
  const auto lives = runLives(registry, *c, {.jobs = 2, .keepRows = false, .interrupted = nullptr, .progress = {}});
  ASSERT_TRUE(lives) << lives.error().message;
  int walking = 0;
  for (const LifeResult& life : *lives) walking += firstWalk(life.greedyTests, life.taskMeasures) != nullptr;
  EXPECT_GE(walking, 16);
}

}  // namespace surefoot
