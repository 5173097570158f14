// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/kiosk/kiosk_window.h"

#include <gtest/gtest.h>

#include <QTest>

#include "core/lessons/reading/lesson_library.h"
#include "tests/core/experiment/test_setup.h"
#include "ui/lessons/kiosk/kiosk_robot.h"
#include "ui/lessons/kiosk/share_slider.h"
#include "ui/style/scale.h"

namespace surefoot {

namespace {

struct Kiosk {
  explicit Kiosk(int resetAfter) : registry(fullRegistry()) {
    const auto read = readLessonFile(registry, SUREFOOT_SOURCE "/resources/lessons/05-exploring-costs-falls.toml");
    EXPECT_TRUE(read && read->lesson && read->lesson->kiosk);
    const auto start = kioskStart(registry, *read->lesson);
    EXPECT_TRUE(start);
    window = std::make_unique<KioskWindow>(registry, *read->lesson, *start, resetAfter);
    window->resize(1280, 720);
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    EXPECT_TRUE(QTest::qWaitFor([&] { return life(0).running() && life(1).running(); }, 20'000));
  }
  ~Kiosk() { applyTextSize(1); }
  RunningLife& life(int which) { return window->robot(which).session().life(); }
  double epsilon() { return life(0).configuration().parameters.get("policy.epsilon"); }

  Registry registry;
  std::unique_ptr<KioskWindow> window;
};

}  // namespace

TEST(Kiosk, BothExploreEquallyOftenAndBeginWithTheSameSeed) {
  Kiosk k(90);
  EXPECT_EQ(k.life(0).configuration().seed, k.life(1).configuration().seed);
  EXPECT_EQ(k.life(0).configuration().names.policy, "epsilon-greedy");
  EXPECT_EQ(k.life(1).configuration().names.policy, "softmax");
  EXPECT_DOUBLE_EQ(k.epsilon(), 0.1 * 5 / 4) << "one of five actions is the best one";
  double shares[2] = {0, 0};
  for (const int which : {0, 1}) {
    Configuration c = k.life(which).began();
    c.episodes = 200;
    auto life = makeLife(k.registry, c, 0, false);
    ASSERT_TRUE(life);
    while (!(*life)->finished()) (*life)->step();
    shares[which] = static_cast<double>((*life)->agent().explored()) / static_cast<double>((*life)->steps());
  }
  EXPECT_NEAR(shares[0], 0.1, 0.01);
  EXPECT_NEAR(shares[1], 0.1, 0.025);
}

TEST(Kiosk, AKeyTurnsTheKnobAndBothBeginAnewASecondLater) {
  Kiosk k(90);
  const double before = k.epsilon();
  QTest::keyClick(k.window.get(), Qt::Key_Left);
  EXPECT_EQ(k.epsilon(), before) << "not while it is being turned";
  ASSERT_TRUE(QTest::qWaitFor([&] { return k.epsilon() < before; }, 5'000));
}

TEST(Kiosk, APushOnOneIsGivenToBoth) {
  Kiosk k(90);
  k.window->robot(1).session().looking().hold(0.2);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        const ValueSnapshot *a = k.life(0).values(), *b = k.life(1).values();
        return a && b && !a->changes.empty() && !b->changes.empty();
      },
      10'000));
  k.window->robot(1).session().looking().hold(std::nullopt);
}

TEST(Kiosk, BeginsAgainByItselfWhenNobodyTouchesIt) {
  Kiosk k(2);
  k.window->slider().setShare(0.3);
  Q_EMIT k.window->slider().moved(0.3);
  ASSERT_TRUE(QTest::qWaitFor([&] { return k.window->slider().share() == 0.1; }, 10'000));
  ASSERT_TRUE(k.window->secondsLeft());
}

TEST(Kiosk, OnlyTheLessonsWordLeavesIt) {
  Kiosk k(90);
  QTest::keyClick(k.window.get(), Qt::Key_Escape);
  EXPECT_TRUE(k.window->isVisible());
  QTest::keyClick(k.window.get(), Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
  QTest::keyClicks(k.window->focusWidget(), "please");
  QTest::keyClick(k.window->focusWidget(), Qt::Key_Return);
  EXPECT_TRUE(k.window->isVisible());
  QTest::keyClick(k.window.get(), Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
  QTest::keyClicks(k.window->focusWidget(), "exploring-costs-falls");
  QTest::keyClick(k.window->focusWidget(), Qt::Key_Return);
  EXPECT_FALSE(k.window->isVisible());
}

}  // namespace surefoot
