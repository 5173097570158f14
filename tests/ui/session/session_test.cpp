// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/session.h"

#include <QSignalSpy>
#include <QTest>

#include "core/experiment/experiment.h"
#include "tests/ui/window_setup.h"

namespace surefoot {

// With the window open, every panel drawn, in turbo: the same bits as headless.
TEST(Session, TheSameHashAsHeadless) {
  Window w("trl", 2000);
  const auto alone =
      runLives(w.registry, w.configuration, {.jobs = 1, .keepRows = false, .interrupted = nullptr, .progress = {}});
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().finished; }, 60'000));
  EXPECT_FALSE(w.waitFor([&] { return w.session->life().running(); }, 100)) << "a finished life does not run on";
  const auto life = w.session->life().finish();
  EXPECT_EQ(life->log().totals().episodes, 2000);
  EXPECT_EQ(life->hash(), (*alone)[0].hash);
}

TEST(Session, ARestartBeginsAgainWithTheSameBits) {
  Window w("softmax", 300);
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().finished; }, 60'000));
  const LifeTotals first = w.session->life().snapshot().totals;
  const auto& curve = w.session->life().curves().live().points;
  ASSERT_TRUE(w.waitFor([&] { return !curve.empty() && curve.back().episode == 300; }));
  w.session->editing().setPolicy("greedy");  // after the end: the life that was keeps its own policy's colour
  QTest::qWait(300);
  EXPECT_EQ(w.session->life().curves().live().policy(), "softmax");
  w.session->editing().setPolicy("softmax");
  ASSERT_TRUE(w.session->newLives().restart());
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 2 && w.session->life().snapshot().finished; },
                        60'000));
  EXPECT_EQ(w.session->life().snapshot().totals.falls, first.falls);
  EXPECT_EQ(w.session->life().snapshot().totals.successSteps, first.successSteps);
  ASSERT_EQ(w.session->life().curves().earlier().size(), 1u) << "the first life stays as a faint curve";
  EXPECT_EQ(w.session->life().curves().earlier()[0].policy(), "softmax");
}

TEST(Session, AChangedParameterReachesTheLearnerAndIsNoted) {
  Window w("epsilon-greedy");
  ASSERT_TRUE(w.session->editing().setParameter("policy.epsilon", 0.25));
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().changedAt("policy.epsilon").has_value(); }));
  EXPECT_EQ(w.session->life().changedAt("policy.epsilon"), 0);
  const auto life = w.session->life().finish();
  EXPECT_EQ(life->parameters().get("policy.epsilon"), 0.25);
}

TEST(Session, AValueOutOfRangeIsRefused) {
  Window w;
  const Status s = w.session->editing().setParameter("policy.epsilon", 1.5);
  ASSERT_FALSE(s);
  EXPECT_EQ(w.session->life().configuration().parameters.get("policy.epsilon"), 0.05);
}

TEST(Session, ATableParameterAsksFirst) {
  Window w;
  QSignalSpy spy(&w.session->editing(), &Editing::needsNewTable);
  ASSERT_TRUE(w.session->editing().setParameter("features.tilings", 8));
  ASSERT_EQ(spy.count(), 1);
  EXPECT_EQ(w.session->life().configuration().parameters.get("features.tilings"), 16);
  ASSERT_TRUE(w.session->newLives().setParameterAndRestart("features.tilings", 8));
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().configuration().parameters.get("features.tilings") == 8; }));
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 2; }));
}

TEST(Session, ATableThatIsTooLargeIsRefusedAndTheOldOneKept) {
  Window w;
  ASSERT_TRUE(w.session->newLives().setParameterAndRestart("features.pole_angle", 1000));
  ASSERT_TRUE(w.waitFor([&] { return !w.session->newLives().background().busy(); }));
  QSignalSpy refused(&w.session->newLives(), &NewLives::refused);
  const Status s = w.session->newLives().setParameterAndRestart("features.pole_rate", 1000);
  EXPECT_TRUE(w.waitFor([&] { return !s || refused.count() == 1; })) << "at once, or when it is found out";
  EXPECT_EQ(w.session->life().configuration().parameters.get("features.pole_rate"), 6);
}

// Work that takes long enough for the window not to wait for it.
TEST(Session, LeoWalksInTheWindowAsHeadless) {
  Window w;
  Names names;
  names.environment = "leo";
  auto c = configure(w.registry, names, {});
  ASSERT_TRUE(c);
  c->episodes = 40;
  const auto alone = runLives(w.registry, *c, {.jobs = 1, .keepRows = false, .interrupted = nullptr, .progress = {}});
  ASSERT_TRUE(w.session->newLives().begin(*c));
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 2 && w.session->life().snapshot().finished; },
                        60'000));
  EXPECT_EQ(w.session->life().finish()->hash(), (*alone)[0].hash);
}

TEST(Background, TheLastThatWasStartedCounts) {
  Background background;
  std::atomic<bool> go{false};
  std::vector<int> done;
  const auto work = [&](const std::atomic<bool>& interrupted) {
    while (!go && !interrupted) std::this_thread::yield();
  };
  for (int i = 0; i < 3; ++i) background.start(work, [&done, i] { done.push_back(i); });
  EXPECT_TRUE(background.busy());
  EXPECT_TRUE(done.empty());
  go = true;
  for (int i = 0; i < 5000 && background.busy(); ++i) QTest::qWait(1);
  EXPECT_EQ(done, std::vector<int>{2});
}

TEST(Background, ShortWorkIsDoneAtOnceAndCancelledWorkNever) {
  Background background;
  bool done = false;
  background.start([](const std::atomic<bool>&) {}, [&] { done = true; }, std::chrono::seconds(30));
  EXPECT_TRUE(done);
  EXPECT_FALSE(background.busy());
  done = false;
  background.start(
      [](const std::atomic<bool>& interrupted) {
        while (!interrupted) std::this_thread::yield();
      },
      [&] { done = true; });
  background.cancel();
  for (int i = 0; i < 5000 && background.busy(); ++i) QTest::qWait(1);
  EXPECT_FALSE(background.busy());
  EXPECT_FALSE(done);
}

TEST(Session, TheThresholdIsThatOfItsSchedule) {
  Window w("trl");
  EXPECT_EQ(w.session->life().threshold(), 50.0);
  ASSERT_TRUE(w.session->editing().setParameter("policy.threshold_schedule", 1.0));
  ASSERT_TRUE(w.session->editing().setParameter("policy.threshold_end", 0.0));
  ASSERT_TRUE(w.session->editing().setParameter("policy.threshold_over", 100.0));
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  EXPECT_TRUE(w.waitFor(
      [&] { return w.session->life().snapshot().totals.episodes > 100 && w.session->life().threshold() == 0.0; }));
  ASSERT_TRUE(w.session->editing().setParameter("policy.threshold_schedule", 3.0));
  EXPECT_TRUE(w.waitFor([&] {
    return w.session->life().values() && w.session->life().values()->rule &&
           w.session->life().threshold() == w.session->life().values()->rule->threshold;
  })) << "the rule of thumb's, as soon as it says something";
}

TEST(Session, ParametersThatDoNotGoTogetherAreRefused) {
  Window w;
  const Status s = w.session->editing().setParameter("environment.fall_angle", 0.1);  // below the start angle
  ASSERT_FALSE(s);
  EXPECT_NE(s.error().message.find("environment.start_angle"), std::string::npos);
  EXPECT_GT(w.session->life().configuration().parameters.get("environment.fall_angle"), 1.0);
}

// What the window reports is what it ran in the end: headless, that configuration gives the same bits.
TEST(Session, ItsConfigurationIsTheOneThatRuns) {
  Window w("trl", 150);
  ASSERT_TRUE(w.session->newLives().setParameterAndRestart("features.tilings", 8));
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 2; }));
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().finished; }, 60'000));
  const Configuration reported = w.session->life().configuration();
  const auto alone =
      runLives(w.registry, reported, {.jobs = 1, .keepRows = false, .interrupted = nullptr, .progress = {}});
  EXPECT_EQ(w.session->life().finish()->hash(), (*alone)[0].hash);
}

TEST(Session, TurboShowsAWorldAtRealTime) {
  Window w;
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().values() && w.session->life().snapshot().steps > 50'000; }));
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().factorText().size() >= 4; }))
      << "turbo is faster than real time";
  EXPECT_EQ(w.session->looking().shown().pose.size(), 5u);
}

}  // namespace surefoot
