// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics over many lives, minutes of CPU time in all: labelled slow.
#include <gtest/gtest.h>

#include "core/experiment/experiment.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

double meanFalls(const std::string& policy, const std::vector<Assignment>& assignments = {}) {
  const Registry r = fullRegistry();
  Configuration c = pendulumConfiguration(r, policy, assignments);
  c.lives = 40;
  c.episodes = 950;
  const auto lives = runLives(r, c, {.jobs = 2, .keepRows = false, .interrupted = nullptr, .progress = {}});
  double sum = 0;
  for (const LifeResult& life : *lives) sum += static_cast<double>(life.totals.falls);
  return sum / 40;
}

}  // namespace

// An independent prototype with the same constants: 213.5 ± 8.9 falls in about 950 episodes.
TEST(PendulumLearning, EpsilonGreedyFallsAsOftenAsTheIndependentPrototype) {
  const double falls = meanFalls("epsilon-greedy");
  EXPECT_GE(falls, 195);
  EXPECT_LE(falls, 235);
}

TEST(PendulumLearning, SoftmaxFallsClearlyLessAndTrlALittle) {
  const double epsilonGreedy = meanFalls("epsilon-greedy");
  EXPECT_LT(meanFalls("softmax", {{"policy.temperature", "1"}}), 0.85 * epsilonGreedy);
  EXPECT_LT(meanFalls("trl", {{"policy.threshold", "50"}}), epsilonGreedy);
}

// Mean length of the successful episodes after the 950th of a life of 9 minutes: the prototype's 55, thesis 50.6.
TEST(PendulumLearning, SuccessesAreShortAfterLearning) {
  const Registry r = fullRegistry();
  Configuration c = pendulumConfiguration(r);
  c.lives = 40;
  c.minutes = 9;
  const auto lives = runLives(r, c, {.jobs = 2, .keepRows = true, .interrupted = nullptr, .progress = {}});
  double steps = 0, count = 0;
  for (const LifeResult& life : *lives)
    for (const EpisodeRow& row : life.rows)
      if (row.episode > 950 && row.success) steps += static_cast<double>(row.steps), ++count;
  EXPECT_GE(steps / count, 50);
  EXPECT_LE(steps / count, 60);
}

}  // namespace surefoot
