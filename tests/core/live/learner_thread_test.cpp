// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/live/learner_thread.h"

#include <chrono>

#include "core/experiment/experiment.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

/// Waits, sleeping, until a snapshot fulfils the condition.
bool waitFor(LearnerThread& learner, const std::function<bool(const Snapshot&)>& condition) {
  for (int i = 0; i < 6000; ++i) {
    learner.wantSnapshot();
    learner.takeSnapshot();
    if (condition(learner.snapshot())) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

}  // namespace

TEST(LearnerThread, StartsPausedAndStepsOnDemand) {
  const Registry r = fullRegistry();
  LearnerThread learner(lifeOf(r, pendulumConfiguration(r)));
  ASSERT_TRUE(waitFor(learner, [](const Snapshot& s) { return s.life == 1; }));
  EXPECT_EQ(learner.snapshot().steps, 0);
  EXPECT_EQ(learner.snapshot().q.size(), 5u);
  learner.send(SingleStep{});
  learner.send(SingleStep{});
  EXPECT_TRUE(waitFor(learner, [](const Snapshot& s) { return s.steps == 2; }));
}

// A snapshot that nobody fetched before the next is not missed.
TEST(LearnerThread, TellsEveryStepToWhoeverWantsThem) {
  const Registry r = fullRegistry();
  LearnerThread learner(lifeOf(r, pendulumConfiguration(r)));
  learner.wantSteps(true);
  learner.send(SetRunning{true});
  std::vector<std::int64_t> steps;
  for (int i = 0; i < 60; ++i) {
    learner.wantSnapshot();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (i % 3 != 2 || !learner.takeSnapshot()) continue;
    for (const StepSeen& step : learner.snapshot().seen)
      if (steps.empty() || step.steps > steps.back()) steps.push_back(step.steps);
  }
  const auto life = learner.stop();
  std::int64_t missed = 0;
  for (std::size_t k = 1; k < steps.size(); ++k) missed += steps[k] - steps[k - 1] - 1;
  EXPECT_GT(steps.size(), 10u);
  EXPECT_LE(missed, life->log().totals().episodes) << "but the first moment of an episode";
}

TEST(LearnerThread, KeepsPaceWithTheClock) {
  const Registry r = fullRegistry();
  LearnerThread learner(lifeOf(r, pendulumConfiguration(r)));
  learner.send(SetRunning{true});
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const auto life = learner.stop();
  EXPECT_GT(life->steps(), 10);   // 100 steps of 5 ms; a loaded machine may do fewer
  EXPECT_LT(life->steps(), 200);  // but never many more
}

// Whoever looks, however often: the watched life ends with the same bits as the one that nobody watched.
TEST(LearnerThread, TheSameBitsAsWithoutIt) {
  const Registry r = fullRegistry();
  Configuration c = pendulumConfiguration(r, "trl");
  c.episodes = 3000;
  const auto alone = runLives(r, c, {.jobs = 1, .keepRows = false, .interrupted = nullptr, .progress = {}});
  LearnerThread learner(lifeOf(r, c));
  learner.send(SetTurbo{true});
  learner.send(SetRunning{true});
  ASSERT_TRUE(waitFor(learner, [&](const Snapshot& s) {
    learner.wantValues();
    learner.takeValues();
    return s.finished;
  }));
  const auto life = learner.stop();
  EXPECT_EQ(life->log().totals().episodes, 3000);
  EXPECT_EQ(life->hash(), (*alone)[0].hash);
}

TEST(LearnerThread, AReplacedLifeStartsAtZeroAndIsNumbered) {
  const Registry r = fullRegistry();
  const Configuration c = pendulumConfiguration(r);
  LearnerThread learner(lifeOf(r, c));
  learner.send(SetTurbo{true});
  learner.send(SetRunning{true});
  ASSERT_TRUE(waitFor(learner, [](const Snapshot& s) { return s.totals.episodes > 10; }));
  learner.send(SetRunning{false});
  learner.send(ReplaceLife{lifeOf(r, c)});
  ASSERT_TRUE(waitFor(learner, [](const Snapshot& s) { return s.life == 2; }));
  EXPECT_EQ(learner.snapshot().steps, 0);
}

TEST(LearnerThread, ShowsCurveAndChanges) {
  const Registry r = fullRegistry();
  LearnerThread learner(lifeOf(r, pendulumConfiguration(r)));
  learner.send(SetParameter{"policy.epsilon", 0.2});
  learner.send(SetTurbo{true});
  learner.send(SetRunning{true});
  ASSERT_TRUE(waitFor(learner, [](const Snapshot& s) { return s.totals.episodes > 50; }));
  for (int i = 0; i < 1000 && learner.values().curve.empty(); ++i) {
    learner.wantValues();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    learner.takeValues();
  }
  ASSERT_FALSE(learner.values().curve.empty());
  ASSERT_EQ(learner.values().changes.size(), 1u);
  EXPECT_EQ(learner.values().changes[0].after, "0.2");
}

}  // namespace surefoot
