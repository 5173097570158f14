// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/handed_in/grading.h"
#include "tests/ui/lessons/taking.h"

namespace surefoot {

// Whatever is shown and whoever looks, the lesson's life is the one that is lived without a window, bit for bit.
TEST(LessonDriver, LivesTheLessonAsItIsLivedWithoutAWindow) {
  Taking t;
  auto lived = LessonLife::begin(t.registry, t.lesson(), 7);
  ASSERT_TRUE(lived);
  t.driver->enter(0);
  ASSERT_TRUE(t.opens(0));
  lived->run(*t.lesson().steps[0].run->amount);
  EXPECT_EQ(t.hash(), lived->life().hash()) << "the run stops at its end, not at a look";
  const double falls = static_cast<double>(lived->life().log().totals().falls);
  EXPECT_EQ(t.driver->observed(0), falls);

  t.driver->next();
  ASSERT_TRUE(t.opens(1));
  EXPECT_EQ(t.driver->text(), QStringLiteral("It fell %1 times.").arg(falls));
  EXPECT_FALSE(t.driver->mayGoOn());
  t.driver->say(40);
  ASSERT_TRUE(t.opens(2)) << "the prediction's run leads on by itself";
  ASSERT_TRUE(lived->act(t.lesson().steps[1].predict->then));
  lived->run(t.lesson().steps[1].predict->after);
  EXPECT_EQ(t.hash(), lived->life().hash());
  EXPECT_EQ(t.driver->observed(1), static_cast<double>(lived->life().log().totals().falls));
  EXPECT_EQ(t.driver->predicted(1), 40.0);

  QSignalSpy judged(t.driver.get(), &LessonDriver::judged);
  t.driver->choose(0, "so");
  EXPECT_FALSE(t.driver->mayGoOn());
  t.driver->choose(1, "so");
  EXPECT_TRUE(t.driver->mayGoOn());
  EXPECT_EQ(judged.count(), 2);

  t.driver->next();
  ASSERT_TRUE(t.opens(3));
  ASSERT_TRUE(lived->act(t.lesson().steps[3].begin));
  EXPECT_EQ(t.hash(), lived->life().hash());
  EXPECT_EQ(t.driver->session().life().configuration().parameters.get("policy.epsilon"), 0);
}

TEST(LessonDriver, AStepThatIsResetBeginsAsItBegan) {
  Taking t;
  t.driver->enter(0);
  ASSERT_TRUE(t.opens(0));
  t.driver->next();
  ASSERT_TRUE(t.opens(1));
  const std::uint64_t before = t.hash();
  t.driver->session().life().setTurbo(true);
  t.driver->session().life().setRunning(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return t.driver->session().life().numbers().episodes > 150; }, 20'000));
  t.driver->resetStep();
  ASSERT_TRUE(t.opens(1));
  EXPECT_EQ(t.hash(), before);
  t.driver->say(10);
  ASSERT_TRUE(t.opens(2));
}

// What the student's hands do after a step's own run does not spoil the steps behind it.
TEST(LessonDriver, TheNextStepBeginsAsTheLessonWasChecked) {
  Taking t;
  auto lived = LessonLife::begin(t.registry, t.lesson(), 7);
  ASSERT_TRUE(lived);
  lived->run(*t.lesson().steps[0].run->amount);
  const std::uint64_t hash = lived->life().hash();
  t.driver->enter(0);
  ASSERT_TRUE(t.opens(0));
  Session& session = t.driver->session();
  ASSERT_TRUE(session.editing().setParameter("policy.epsilon", 0.7));
  session.life().setTurbo(true);
  session.life().setRunning(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return session.life().numbers().episodes > 150; }, 20'000));
  t.driver->next();
  ASSERT_TRUE(t.opens(1));
  EXPECT_EQ(t.hash(), hash);
  EXPECT_EQ(session.life().configuration().parameters.get("policy.epsilon"), 0.05);
  // A knob alone, too.
  t.driver->back();
  ASSERT_TRUE(t.opens(0));
  ASSERT_TRUE(session.editing().setParameter("policy.epsilon", 0.7));
  t.driver->next();
  ASSERT_TRUE(t.opens(1));
  EXPECT_EQ(session.life().configuration().parameters.get("policy.epsilon"), 0.05);
  // Back to a step that was done: it is as it was, with what was said.
  t.driver->say(40);
  ASSERT_TRUE(t.opens(2));
  const std::uint64_t after = t.hash();
  t.driver->back();
  ASSERT_TRUE(t.opens(1));
  EXPECT_EQ(t.hash(), hash);
  EXPECT_TRUE(t.driver->mayGoOn()) << "it was said before";
  t.driver->next();
  ASSERT_TRUE(t.opens(2));
  EXPECT_EQ(t.hash(), after);
}

// Back and on again, the curves of the lives before are there, each once.
TEST(LessonDriver, CurvesAreThereAgainAfterTheWayBack) {
  Taking t;
  t.driver->enter(0);
  ASSERT_TRUE(t.opens(0));
  t.driver->next();
  ASSERT_TRUE(t.opens(1));
  t.driver->say(40);
  ASSERT_TRUE(t.opens(2));
  const RunCurves& curves = t.driver->session().life().curves();
  const auto falls = [&] {
    std::vector<std::int64_t> all;
    for (const RunCurve& curve : curves.earlier()) all.push_back(curve.points.back().falls);
    return all;
  };
  const auto before = falls();
  ASSERT_EQ(before.size(), 1u);
  for (int times = 0; times < 2; ++times) {
    t.driver->back();
    ASSERT_TRUE(t.opens(1));
    EXPECT_TRUE(curves.earlier().empty()) << "the second life was not lived yet";
    t.driver->next();
    ASSERT_TRUE(t.opens(2));
    EXPECT_EQ(falls(), before);
  }
}

TEST(LessonDriver, SeveralLivesAreThoseOfTheProgram) {
  Taking t;
  t.driver->enter(4);
  ASSERT_TRUE(t.opens(4));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !t.driver->lives().empty(); }, 20'000));
  auto lived = LessonLife::begin(t.registry, t.lesson(), 7);
  ASSERT_TRUE(lived);
  ASSERT_TRUE(lived->act(t.lesson().steps[4].begin));
  EXPECT_EQ(t.hash(), lived->life().hash());
  const auto ways =
      liveWays(t.registry, t.lesson(), *t.lesson().steps[4].lives, lived->configuration(), lived->values(), 1);
  ASSERT_TRUE(ways);
  EXPECT_EQ(t.driver->lives(), *ways);
  QSignalSpy judged(t.driver.get(), &LessonDriver::judged);
  t.driver->compared(Compared::First);
  ASSERT_TRUE(QTest::qWaitFor([&] { return judged.count() > 0; }, 5'000));
  EXPECT_EQ(t.driver->mayGoOn(), surefoot::compare((*ways)[0], (*ways)[1]).answer == Compared::First);
}

// Left in the middle and gone on with another day, from the file alone; and what was done is graded as it was.
TEST(LessonDriver, GoesOnFromWhatWasWrittenDown) {
  std::string text;
  std::uint64_t hash = 0;
  {
    Taking t;
    HandInWriter writer;
    text = writer.header(t.driver->handIn());
    QObject::connect(t.driver.get(), &LessonDriver::marked, [&](const LessonMark& mark) { text += writer.line(mark); });
    t.driver->enter(0);
    ASSERT_TRUE(t.opens(0));
    t.driver->next();
    ASSERT_TRUE(t.opens(1));
    t.driver->say(40);
    ASSERT_TRUE(t.opens(2));
    t.driver->choose(1, "so");
    t.driver->next();
    ASSERT_TRUE(t.opens(3));
    t.driver->next();
    ASSERT_TRUE(t.opens(4)) << "a task can be skipped";
    t.driver->next();
    ASSERT_TRUE(t.opens(5));
    hash = t.hash();
  }
  const auto handIn = parseHandIn(text);
  ASSERT_TRUE(handIn) << handIn.error().message;
  Taking again(*handIn);
  EXPECT_EQ(handIn->reached(again.lesson()), 5u);
  again.driver->goOn(5);
  ASSERT_TRUE(again.opens(5));
  EXPECT_EQ(again.hash(), hash);
  EXPECT_EQ(again.driver->predicted(1), 40.0);
  QSignalSpy judged(again.driver.get(), &LessonDriver::judged);
  again.driver->number(1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return judged.count() > 0; }, 5'000));

  const Grade grade = gradeOf(again.registry, again.lesson(), *handIn);
  EXPECT_TRUE(grade.trusted) << (grade.remarks.empty() ? "" : grade.remarks[0]);
  EXPECT_EQ(grade.rightAtOnce, 1);
  EXPECT_EQ(grade.tasksDone, 0);
}

TEST(LessonDriver, LeavingInTheMiddleOfAnythingIsFine) {
  for (const int wait : {0, 1, 5, 20, 60}) {
    Taking t;
    t.driver->enter(0);
    QTest::qWait(wait);
    t.driver->enter(4);
    QTest::qWait(wait);
    t.driver->resetStep();
    t.driver->enter(1);
    QTest::qWait(wait);
    t.driver->say(3);
    QTest::qWait(wait);
  }
}

}  // namespace surefoot
