// SPDX-License-Identifier: GPL-3.0-or-later
// What happens to what was learned when the window is closed, when it crashes, and when a life gives way to another.
#include <QDir>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "tests/ui/session/learn_and_answer.h"
#include "ui/live/live_page.h"
#include "ui/live/rival.h"
#include "ui/window/autosave.h"

namespace surefoot {

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
    ASSERT_TRUE(w.waitFor([&] { return w.session->life().progress().episodes >= 30; }));
    EXPECT_TRUE(w.session->life().unsaved());
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
    ASSERT_TRUE(w.waitFor([&] { return w.session->life().progress().episodes == 0; }));
  }
  w.window->close();
  EXPECT_TRUE(w.window->messages().accessibleName().contains("2 lives before this one"))
      << w.window->messages().accessibleName().toStdString();
  answer(w, "Don't save");
  ASSERT_TRUE(w.waitFor([&] { return !w.window->isVisible(); }));
  EXPECT_EQ(last().size(), 3);
  for (const QString& file : data().entryList({"autosave-*", "last-session-*"}, QDir::Files)) data().remove(file);
}

TEST(Quit, AsksForWhatTheSecondLearned) {
  Window w;
  w.window->livePage().setComparing(true);
  Session& second = w.window->livePage().rival()->session();
  second.life().setTurbo(true);
  second.life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return second.life().progress().episodes >= 5; }, 30'000));
  second.life().setRunning(false);
  w.window->close();
  EXPECT_TRUE(w.window->isVisible());
  EXPECT_TRUE(w.window->messages().accessibleName().contains("the second learned in"))
      << w.window->messages().accessibleName().toStdString();
  answer(w, "Cancel");
}

TEST(Quit, WhatCannotBeKeptIsToldAndTheAutosaveStays) {
  QTemporaryDir folder;
  Window w;
  Session session(w.registry, w.configuration, false);
  MainWindow window(session, {.plans = {}, .folder = folder.path()});
  window.show();
  session.life().setTurbo(true);
  session.life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return session.life().progress().episodes > 20; }));
  session.life().setRunning(false);
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
  w.session->looking().stepOnce();
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps == 1; }));
  EXPECT_TRUE(w.window->close());
}

TEST(Quit, AnEndFromOutsideNeverAsks) {
  QTemporaryDir folder;
  Window w;
  Session session(w.registry, w.configuration, false);
  MainWindow window(session, {.plans = {}, .folder = folder.path()});
  window.show();
  session.life().setTurbo(true);
  session.life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return session.life().progress().episodes > 20; }));
  window.closeForNow();
  EXPECT_TRUE(w.waitFor([&] { return !window.isVisible(); }));
  EXPECT_EQ(QDir(folder.path()).entryList({"autosave-*.surefoot"}, QDir::Files).size(), 1);
}

// A restart does not write a new life over a long one that was on the disk.
TEST(Autosave, ALifeThatGaveWayStaysOnTheDiskUntilItIsSaved) {
  QTemporaryDir folder;
  Window w;
  Autosave autosave(w.session->life(), w.session->history(), w.session->files(), folder.path());
  const auto files = [&] { return QDir(folder.path()).entryList({"autosave-*.surefoot"}, QDir::Files).size(); };
  learn(w, 30);
  autosave.save();
  ASSERT_TRUE(w.waitFor([&] { return files() == 1; }));
  w.key(Qt::Key_R);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 2; }));
  learn(w, 5);
  autosave.save();
  EXPECT_TRUE(w.waitFor([&] { return files() == 2; })) << "both are there";
  w.session->history().undo().undo();
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().progress().episodes >= 30; }));
  learn(w, w.session->life().progress().episodes + 5);
  autosave.save();
  EXPECT_TRUE(w.waitFor([&] { return files() == 2; })) << "the other way round";
  autosave.finish();
  EXPECT_TRUE(w.waitFor([&] { return files() == 0; })) << "the one in writing, too";
  QTest::qWait(50);
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
  const Autosave autosave(w.session->life(), w.session->history(), w.session->files(), folder.path());
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
  const Autosave autosave(w.session->life(), w.session->history(), w.session->files(), folder.path());
  EXPECT_EQ(autosave.leftBehind(), QString());
}

}  // namespace surefoot
