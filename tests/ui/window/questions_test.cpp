// SPDX-License-Identifier: GPL-3.0-or-later
// No careless key answers a question: the focus stays where the person was, and messages do not push questions away.
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>

#include "tests/ui/session/learn_and_answer.h"
#include "tests/ui/window_setup.h"
#include "ui/controls/message_bar.h"
#include "ui/live/live_page.h"
#include "ui/live/world/world_view.h"

namespace surefoot {

namespace {

struct Asked {
  const char* name;
  const char* answer;  ///< that destroys
  std::function<void(Window&)> ask;
};

std::vector<Asked> questions() {
  return {
      {"new table", "Start again",
       [](Window& w) { ASSERT_TRUE(w.session->editing().setParameter("features.tilings", 8)); }},
      {"learning rule", "Start again",
       [](Window& w) {
         auto* agent = w.named<QComboBox>("Learning rule");
         Q_EMIT agent->activated(agent->findData("sarsa-2q"));
       }},
      {"compare", "Begin both again", [](Window& w) { w.key(Qt::Key_C); }},
      {"quit", "Don't save", [](Window& w) { QTest::keyClick(w.window.get(), Qt::Key_Q, Qt::ControlModifier); }},
      {"restore", "Forget it",
       [](Window& w) {
         w.window->messages().ask("The last session was not closed.", {{"Restore it", {}}, {"Forget it", {}}},
                                  MessageBar::Question::Lasting);
       }},
      {"no memory", "End it",
       [](Window& w) {
         w.session->history().setMostKept(0);
         w.key(Qt::Key_R);
       }},
  };
}

}  // namespace

TEST(Questions, NoCarelessKeyAnswersOne) {
  for (const Asked& asked : questions()) {
    SCOPED_TRACE(asked.name);
    Window w("trl");
    learn(w, 100);
    w.window->livePage().world().setFocus();
    const std::int64_t episodes = w.session->life().progress().episodes;
    QWidget* const focus = QApplication::focusWidget();
    asked.ask(w);
    QTest::qWait(20);
    ASSERT_TRUE(answersOf(w).contains(asked.answer)) << answersOf(w).join(", ").toStdString();
    EXPECT_EQ(QApplication::focusWidget(), focus) << "the focus stays where the person was";
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Space, Qt::Key_Space}) {
      QTest::keyClick(QApplication::focusWidget(), key);
      QTest::qWait(10);
    }
    EXPECT_TRUE(answersOf(w).contains(asked.answer)) << "not answered";
    EXPECT_TRUE(w.window->isVisible());
    EXPECT_GE(w.session->life().progress().episodes, episodes) << "the life is still there";
    EXPECT_EQ(w.session->life().snapshot().life, 1u);
    for (auto* button : w.window->messages().findChildren<QPushButton*>()) {
      EXPECT_FALSE(button->isDefault() || button->autoDefault()) << button->text().toStdString();
      EXPECT_FALSE(button->hasFocus()) << button->text().toStdString();
    }
  }
}

TEST(Questions, AFieldKeepsTheFocusWhenItsValueNeedsANewTable) {
  Window w;
  auto* number = w.named<QLineEdit>("Tilings, number");
  number->setFocus();
  number->selectAll();
  QTest::keyClicks(number, "8");
  QTest::keyClick(number, Qt::Key_Return);
  ASSERT_TRUE(w.window->messages().isVisible());
  EXPECT_FALSE(w.window->messages().isAncestorOf(QApplication::focusWidget()));
}

TEST(Questions, ALastingOneStaysUntilItIsAnswered) {
  Window w;
  int restored = 0;
  w.window->messages().ask("Restore?", {{"Restore it", [&] { ++restored; }}, {"Forget it", {}}},
                           MessageBar::Question::Lasting);
  w.window->messages().say("Something else went wrong.");
  w.window->messages().tell("Something is written.");
  ASSERT_TRUE(w.session->editing().setParameter("features.tilings", 8));
  EXPECT_TRUE(answersOf(w).contains("Start again")) << "beside it";
  learn(w, 20);
  w.key(Qt::Key_R);
  w.key(Qt::Key_Escape);
  ASSERT_TRUE(w.session->editing().setParameter("policy.threshold", 20.0));
  ASSERT_TRUE(w.session->newLives().beginEnvironment("cliff"));
  w.window->setPage(1);
  w.window->setPage(0);
  w.window->messages().dismiss();
  QTest::qWait(50);
  ASSERT_TRUE(w.window->messages().isVisible());
  answer(w, "Restore it");
  EXPECT_EQ(restored, 1);
  EXPECT_FALSE(answersOf(w).contains("Restore it"));
}

TEST(Questions, MessagesOfOneMomentStandTogether) {
  Window w;
  w.window->messages().tell("A life has begun.");
  w.window->messages().tell("The life before is kept.");
  EXPECT_EQ(w.window->messages().accessibleName(), "A life has begun. The life before is kept.");
}

}  // namespace surefoot
