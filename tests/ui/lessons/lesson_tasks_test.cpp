// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/lessons/taking.h"

namespace surefoot {

TEST(LessonTasks, ATaskTicksItselfAfterTheStepThatDoesIt) {
  Taking t;
  t.driver->enter(3);
  ASSERT_TRUE(t.opens(3));
  EXPECT_FALSE(t.driver->mayGoOn());
  Session& session = t.driver->session();
  ASSERT_TRUE(session.editing().setParameter("policy.epsilon", 0.5));
  ASSERT_TRUE(session.newLives().restart());
  session.life().setTurbo(true);
  session.life().setRunning(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return t.driver->taskDone(); }, 20'000)) << "it is watched over a restart";
  const LessonMark* done = t.driver->handIn().last(LessonMark::Kind::Done, 3);
  ASSERT_TRUE(done && done->life);
  const auto again = relive(t.registry, t.lesson(), *done->life);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->life->log().totals().episodes, 50) << "the very step";
  EXPECT_FALSE(session.life().running()) << "in turbo it would be far beyond before one has seen it";
}

// An attempt that is over without the task is told, and the life pauses there.
TEST(LessonTasks, AnAttemptEndsAndIsTold) {
  Taking t;
  t.driver->enter(3);
  ASSERT_TRUE(t.opens(3));
  Session& session = t.driver->session();
  const QSignalSpy judged(t.driver.get(), &LessonDriver::judged);
  const auto live = [&] {
    session.life().setTurbo(true);
    session.life().setRunning(true);
    return QTest::qWaitFor([&] { return !judged.isEmpty() && !session.life().running(); }, 20'000);
  };
  ASSERT_TRUE(live()) << "with ε = 0 the attempt fails";
  EXPECT_FALSE(t.driver->taskDone());
  EXPECT_TRUE(QTest::qWaitFor([&] { return session.life().progress().episodes >= 60; }, 2'000));
  EXPECT_TRUE(QTest::qWaitFor([&] { return session.life().snapshot().totals.episodes == 60; }, 5'000));
  EXPECT_FALSE(judged.at(0).at(0).value<LessonVerdict>().right);
  // To run on is to try again, from the beginning.
  const auto life = session.life().snapshot().life;
  t.driver->run();
  EXPECT_TRUE(QTest::qWaitFor([&] { return session.life().snapshot().life != life; }, 5'000));
  EXPECT_TRUE(QTest::qWaitFor([&] { return judged.size() == 2; }, 20'000)) << "that attempt ends, too";
  EXPECT_TRUE(QTest::qWaitFor([&] { return session.life().snapshot().totals.episodes == 60; }, 5'000));
}

}  // namespace surefoot
