// SPDX-License-Identifier: GPL-3.0-or-later
// Everything without a mouse.
#include "ui/support/keyboard.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>

#include "core/scene.h"
#include "tests/ui/window_setup.h"
#include "ui/controls/message_bar.h"
#include "ui/controls/slider.h"
#include "ui/live/live_page.h"
#include "ui/live/world/world_view.h"

namespace surefoot {

namespace {

/// A key to whatever has the focus, as a keyboard sends it: shortcuts first.
void press(QWidget* widget, Qt::Key key) {
  widget->setFocus(Qt::TabFocusReason);
  QTest::keyClick(widget, key);
}

}  // namespace

TEST(Keyboard, ButtonsArePressedBySpaceAndReturn) {
  Window w;
  auto* turbo = w.named<QAbstractButton>("Turbo");
  press(turbo, Qt::Key_Return);
  EXPECT_TRUE(w.session->life().turbo());
  press(turbo, Qt::Key_Space);
  EXPECT_FALSE(w.session->life().turbo());
  EXPECT_FALSE(w.session->life().running()) << "Space was the button's";
  press(&w.window->livePage().world(), Qt::Key_Space);
  EXPECT_TRUE(w.session->life().running()) << "and elsewhere it runs and pauses";
}

TEST(Keyboard, ArrowsMoveTheSliderThatHasTheFocus) {
  Window w;
  auto* slider = w.named<Slider>("Step size");
  const int before = slider->value();
  press(slider, Qt::Key_Right);
  EXPECT_GT(slider->value(), before);
  press(slider, Qt::Key_Left);
  EXPECT_EQ(slider->value(), before);
  QTest::qWait(50);
  EXPECT_EQ(w.session->life().snapshot().steps, 0) << "not a step of the world";
  EXPECT_FALSE(w.session->looking().playback());
}

TEST(Keyboard, ChoicesOpenAndAreTakenByReturn) {
  Window w;
  auto* policy = w.named<QComboBox>("Policy");
  const int before = policy->currentIndex();
  press(policy, Qt::Key_Down);
  EXPECT_TRUE(policy->view()->isVisible());
  EXPECT_EQ(policy->currentIndex(), before) << "looking is not choosing";
  policy->hidePopup();
}

TEST(Keyboard, AQuestionIsAnsweredAndCancelled) {
  Window w;
  auto* combo = w.named<QComboBox>("Learning rule");
  combo->setFocus();
  const auto ask = [&] { Q_EMIT combo->activated(combo->findData("sarsa-2q")); };
  ask();
  ASSERT_TRUE(w.window->messages().isVisible());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
  EXPECT_FALSE(w.window->messages().isVisible());
  EXPECT_TRUE(combo->hasFocus()) << "back where it was";
  EXPECT_EQ(w.session->life().configuration().names.agent, "sarsa");
  ask();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  EXPECT_EQ(w.session->life().configuration().names.agent, "sarsa") << "a key that was meant for something else";
  for (auto* answer : w.window->messages().findChildren<QPushButton*>())
    if (answer->isVisible() && answer->text() == "Start again") press(answer, Qt::Key_Space);
  EXPECT_EQ(w.session->life().configuration().names.agent, "sarsa-2q");
}

TEST(Keyboard, ANumberThatIsReachedByTabIsReplaced) {
  Window w;
  auto* number = w.named<QLineEdit>("Fall, number");
  w.named<Slider>("Fall")->setFocus();
  number->setFocus(Qt::TabFocusReason);
  QTest::qWait(20);
  QTest::keyClicks(number, "-150");
  QTest::keyClick(number, Qt::Key_Return);
  EXPECT_EQ(w.session->life().configuration().parameters.get("environment.fall_reward"), -150);
}

TEST(Keyboard, TheKeysOfOnePageDoNothingOnAnother) {
  Window w;
  w.session->looking().stepOnce();
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps == 1; }));
  for (const Qt::Key page : {Qt::Key_2, Qt::Key_3}) {
    QTest::keyClick(w.window.get(), page, Qt::ControlModifier);
    EXPECT_FALSE(w.window->livePage().isVisible());
    for (const Qt::Key key : {Qt::Key_R, Qt::Key_T, Qt::Key_C, Qt::Key_Period, Qt::Key_Space}) w.key(key);
    QTest::qWait(50);
    EXPECT_EQ(w.session->life().snapshot().life, 1u);
    EXPECT_EQ(w.session->life().snapshot().steps, 1);
    EXPECT_FALSE(w.session->life().running());
    EXPECT_FALSE(w.session->life().turbo());
  }
  QTest::keyClick(w.window.get(), Qt::Key_1, Qt::ControlModifier);
  EXPECT_TRUE(w.window->livePage().isVisible());
  w.key(Qt::Key_T);
  EXPECT_TRUE(w.session->life().turbo());
}

TEST(Scene, ForgetsWhatTheLastEnvironmentWanted) {
  Scene scene;
  scene.metres = false;
  scene.width = 7;
  scene.clear();
  EXPECT_TRUE(scene.metres);
  EXPECT_EQ(scene.width, 0);
}

}  // namespace surefoot
