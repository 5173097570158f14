// SPDX-License-Identifier: GPL-3.0-or-later
// No careless key answers a question: the focus stays where the person was, and messages do not push questions away.
#include <QCloseEvent>
#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "tests/ui/window_setup.h"
#include "ui/autosave.h"
#include "ui/live_page.h"
#include "ui/message_bar.h"
#include "ui/world_view.h"

namespace surefoot {

namespace {

QStringList answersOf(MainWindow& window) {
  QStringList texts;
  for (auto* button : window.messages().findChildren<QPushButton*>())
    if (button->isVisible()) texts << button->text();
  return texts;
}
QStringList answersOf(Window& w) {
  return answersOf(*w.window);
}

void answer(MainWindow& window, const QString& text) {
  for (auto* button : window.messages().findChildren<QPushButton*>())
    if (button->isVisible() && button->text() == text) return QTest::mouseClick(button, Qt::LeftButton);
  ADD_FAILURE() << "no answer " << text.toStdString() << " among " << answersOf(window).join(", ").toStdString();
}
void answer(Window& w, const QString& text) {
  answer(*w.window, text);
}

void learn(Window& w, std::int64_t episodes) {
  w.session->setTurbo(true);
  w.session->setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->progress().episodes >= episodes; }, 30'000));
  w.session->setRunning(false);
  ASSERT_TRUE(w.waitFor([&] { return !w.session->snapshot().running; }));
}

struct Asked {
  const char* name;
  const char* answer;  ///< that destroys
  std::function<void(Window&)> ask;
};

std::vector<Asked> questions() {
  return {
      {"new table", "Start again", [](Window& w) { ASSERT_TRUE(w.session->setParameter("features.tilings", 8)); }},
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
         w.session->setMostKept(0);
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
    const std::int64_t episodes = w.session->progress().episodes;
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
    EXPECT_GE(w.session->progress().episodes, episodes) << "the life is still there";
    EXPECT_EQ(w.session->snapshot().life, 1u);
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
  ASSERT_TRUE(w.session->setParameter("features.tilings", 8));
  EXPECT_TRUE(answersOf(w).contains("Start again")) << "beside it";
  learn(w, 20);
  w.key(Qt::Key_R);
  w.key(Qt::Key_Escape);
  ASSERT_TRUE(w.session->setParameter("policy.threshold", 20.0));
  ASSERT_TRUE(w.session->beginEnvironment("cliff"));
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

TEST(Quit, AsksWhereSomethingIsUnsavedAndKeepsTheSessionForTheNextStart) {
  const auto data = [] { return QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)); };
  const auto last = [&] { return data().entryList({"last-session-*.surefoot"}, QDir::Files); };
  {
    Window w;
    learn(w, 30);
    w.window->close();
    EXPECT_TRUE(w.window->isVisible()) << "it asks";
    EXPECT_EQ(answersOf(w), (QStringList{"Save", "Don't save", "Cancel"}));
    answer(w, "Cancel");
    EXPECT_TRUE(w.window->isVisible());
    w.window->close();
    answer(w, "Don't save");
    ASSERT_TRUE(w.waitFor([&] { return !w.window->isVisible(); }));
    EXPECT_EQ(last().size(), 1);
  }
  {
    Window w;
    EXPECT_TRUE(answersOf(w).contains("Go on with it"));
    Session second(w.registry, w.configuration, false);
    MainWindow other(second);
    other.show();
    EXPECT_FALSE(other.messages().isVisible()) << "two windows do not offer the same session";
    answer(w, "Go on with it");
    ASSERT_TRUE(w.waitFor([&] { return w.session->progress().episodes >= 30; }));
    EXPECT_TRUE(w.session->unsaved());
    EXPECT_TRUE(w.waitFor([&] { return last().isEmpty(); })) << "it is this window's now";
  }
  for (const QString& file : data().entryList({"autosave-*", "last-session-*"}, QDir::Files)) data().remove(file);
}

TEST(Quit, AsksForALifeThatOnlyUndoKeeps) {
  Window w;
  learn(w, 30);
  w.key(Qt::Key_R);
  w.window->close();
  EXPECT_TRUE(w.window->isVisible());
  EXPECT_TRUE(answersOf(w).contains("Don't save"));
}

TEST(Quit, NamesAllThatIsNotSavedAndKeepsAllOfIt) {
  const auto data = [] { return QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)); };
  const auto last = [&] { return data().entryList({"last-session-*.surefoot"}, QDir::Files); };
  Window w;
  for (int episodes : {30, 20, 10}) {
    learn(w, episodes);
    if (episodes == 10) break;
    w.key(Qt::Key_R);
    ASSERT_TRUE(w.waitFor([&] { return w.session->progress().episodes == 0; }));
  }
  w.window->close();
  EXPECT_TRUE(w.window->messages().accessibleName().contains("2 lives before this one"))
      << w.window->messages().accessibleName().toStdString();
  answer(w, "Don't save");
  ASSERT_TRUE(w.waitFor([&] { return !w.window->isVisible(); }));
  EXPECT_EQ(last().size(), 3);
  for (const QString& file : data().entryList({"autosave-*", "last-session-*"}, QDir::Files)) data().remove(file);
}

TEST(Quit, WhatCannotBeKeptIsToldAndTheAutosaveStays) {
  QTemporaryDir folder;
  Window w;
  Session session(w.registry, w.configuration, false);
  MainWindow window(session, {.plans = {}, .folder = folder.path()});
  window.show();
  session.setTurbo(true);
  session.setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return session.progress().episodes > 20; }));
  session.setRunning(false);
  ASSERT_TRUE(QDir(folder.path()).removeRecursively());
  QFile inItsPlace(folder.path());  // no folder can be made there
  ASSERT_TRUE(inItsPlace.open(QIODevice::WriteOnly));
  window.close();
  answer(window, "Don't save");
  ASSERT_TRUE(w.waitFor([&] { return window.messages().accessibleName().contains("could not be kept"); }))
      << window.messages().accessibleName().toStdString();
  EXPECT_TRUE(window.isVisible());
  window.close();
  answer(window, "Don't save");
  EXPECT_TRUE(w.waitFor([&] { return !window.isVisible(); })) << "once is enough";
  inItsPlace.remove();
}

TEST(Quit, DoesNotAskWhereNothingWasLearned) {
  Window w;
  w.session->stepOnce();
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().steps == 1; }));
  EXPECT_TRUE(w.window->close());
}

TEST(Quit, AnEndFromOutsideNeverAsks) {
  QTemporaryDir folder;
  Window w;
  Session session(w.registry, w.configuration, false);
  MainWindow window(session, {.plans = {}, .folder = folder.path()});
  window.show();
  session.setTurbo(true);
  session.setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return session.progress().episodes > 20; }));
  window.closeForNow();
  EXPECT_TRUE(w.waitFor([&] { return !window.isVisible(); }));
  EXPECT_EQ(QDir(folder.path()).entryList({"autosave-*.surefoot"}, QDir::Files).size(), 1);
}

// A restart does not write a new life over a long one that was on the disk.
TEST(Autosave, ALifeThatGaveWayStaysOnTheDiskUntilItIsSaved) {
  QTemporaryDir folder;
  Window w;
  Autosave autosave(*w.session, folder.path());
  const auto files = [&] { return QDir(folder.path()).entryList({"autosave-*.surefoot"}, QDir::Files).size(); };
  learn(w, 30);
  autosave.save();
  ASSERT_TRUE(w.waitFor([&] { return files() == 1; }));
  w.key(Qt::Key_R);
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().life == 2; }));
  learn(w, 5);
  autosave.save();
  EXPECT_TRUE(w.waitFor([&] { return files() == 2; })) << "both are there";
  w.session->undo().undo();
  ASSERT_TRUE(w.waitFor([&] { return w.session->progress().episodes >= 30; }));
  learn(w, w.session->progress().episodes + 5);
  autosave.save();
  EXPECT_TRUE(w.waitFor([&] { return files() == 2; })) << "the other way round";
  autosave.finish();
  EXPECT_EQ(files(), 0);
}

TEST(Autosave, StaleLocksGoAndTheirSessionsAreOffered) {
  Window w;
  QTemporaryDir folder;
  const auto write = [&](const char* name, const QByteArray& bytes) {
    QFile file(folder.filePath(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
  };
  const QByteArray ours = QByteArray::number(QCoreApplication::applicationPid());
  write("autosave-1.surefoot", "a session");
  write("autosave-1.surefoot.lock", ours + "\nui_test\nelsewhere\n\n00000000-another-boot\n");
  write("autosave-2.surefoot.lock", "");
  write("autosave-3.surefoot.lock", "999999\nsurefoot\n");
  const Autosave autosave(*w.session, folder.path());
  EXPECT_EQ(autosave.leftBehind(), folder.filePath("autosave-1.surefoot"));
  for (const char* name : {"autosave-2.surefoot.lock", "autosave-3.surefoot.lock"})
    EXPECT_FALSE(QFile::exists(folder.filePath(name))) << name;
}

TEST(Autosave, WhatAnotherWindowHoldsIsNotOffered) {
  Window w;
  QTemporaryDir folder;
  const QString path = folder.filePath("autosave-7.surefoot");
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  const FileLock held = FileLock::take(path + ".lock");
  ASSERT_TRUE(held.held());
  const Autosave autosave(*w.session, folder.path());
  EXPECT_EQ(autosave.leftBehind(), QString());
}

}  // namespace surefoot
