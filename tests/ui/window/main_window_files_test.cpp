// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

// What the window opens, saves and exports.
#include <QDir>
#include <QTemporaryDir>
#include <cmath>

#include "core/life/lives_version.h"
#include "core/saved/journal.h"
#include "tests/ui/window_setup.h"
#include "ui/controls/message_bar.h"
#include "ui/controls/panel.h"
#include "ui/live/live_page.h"
#include "ui/support/exporting.h"
#include "ui/window/autosave.h"
#include "ui/window/main_window.h"

namespace surefoot {

namespace {
double largest(const std::vector<double>& q) {
  double most = 0;
  for (const double v : q) most = std::max(most, std::abs(v));
  return most;
}
}  // namespace

TEST(MainWindow, ASavedSessionGoesOnWhereItWas) {
  Window w;
  QTemporaryDir folder;
  const QString path = folder.filePath("one.surefoot");
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().totals.episodes > 100; }));
  w.session->life().setRunning(false);
  ASSERT_TRUE(w.waitFor([&] { return !w.session->life().snapshot().running; }));
  w.window->saveTo(SavedAs::Session, path);
  ASSERT_TRUE(w.waitFor([&] { return QFile::exists(path); }));
  QTest::qWait(50);
  const auto before = w.session->life().snapshot().totals;
  const std::int64_t steps = w.session->life().snapshot().steps;
  ASSERT_TRUE(w.session->newLives().restart());
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps == 0; }));
  w.window->openFile(path);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps == steps; }));
  EXPECT_EQ(w.session->life().snapshot().totals.episodes, before.episodes);
  EXPECT_EQ(w.session->life().snapshot().totals.falls, before.falls);
  EXPECT_EQ(w.window->windowTitle(), "Surefoot: one");
}

TEST(MainWindow, ASessionOfAnotherVersionSaysThatItsLifeTakesAnotherCourse) {
  Window w;
  QTemporaryDir folder;
  const QString path = folder.filePath("one.surefoot");
  const auto learnAndSave = [&] {
    w.window->saveTo(SavedAs::Session, path);
    return w.waitFor([&] { return QFile::exists(path); });
  };
  ASSERT_TRUE(learnAndSave());
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  QByteArray bytes = file.readAll();
  const QByteArray was = "\\\"lives_version\\\":" + QByteArray::number(kLivesVersion);
  ASSERT_EQ(bytes.count(was), 1);
  file.seek(0);
  file.write(bytes.replace(was, "\\\"lives_version\\\":7"));
  file.close();
  w.window->openFile(path);
  ASSERT_TRUE(w.waitFor([&] { return w.window->messages().accessibleName().contains("number 7"); }));
  EXPECT_TRUE(w.window->messages().accessibleName().contains("goes on"))
      << w.window->messages().accessibleName().toStdString();
}

// Whoever only wants to look at what was loaded finds out how.
TEST(MainWindow, SaysWhetherWhatWasLoadedLearns) {
  Window w;
  w.session->looking().stepOnce();
  QTemporaryDir folder;
  const QString path = folder.filePath("q.safetensors");
  w.window->saveTo(SavedAs::QFunction, path);
  ASSERT_TRUE(w.waitFor([&] { return QFile::exists(path); }));
  for (const bool runs : {false, true}) {
    w.session->life().setRunning(runs);
    w.window->openFile(path);
    ASSERT_TRUE(w.waitFor([&] { return w.window->messages().accessibleName().contains("q.safetensors is loaded"); }));
    const QString says = w.window->messages().accessibleName();
    EXPECT_TRUE(says.contains("Roll out")) << says.toStdString();
    EXPECT_EQ(says.contains("not running"), !runs) << says.toStdString();
    w.window->messages().dismiss();
  }
}

// What the bar says after a save can be copied into a shell, whatever the name and the environment.
TEST(MainWindow, TheSuggestedCommandsRun) {
  QTemporaryDir folder;
  Window w;
  for (const char* environment : {"pendulum", "leo", "cliff"}) {
    ASSERT_TRUE(w.session->newLives().beginEnvironment(environment));
    ASSERT_TRUE(w.waitFor([&] { return w.session->life().configuration().names.environment == environment; }));
    w.session->life().setTurbo(true);
    w.session->life().setRunning(true);
    ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().totals.episodes > 1; }));
    w.session->life().setRunning(false);
    ASSERT_TRUE(w.waitFor([&] { return !w.session->life().snapshot().running; }));
    for (const SavedAs what : {SavedAs::QFunction, SavedAs::Session, SavedAs::Journal}) {
      const QString path = folder.filePath(QStringLiteral("it's \"%1\" für %2 $HOME").arg(environment).arg(int(what)));
      w.window->saveTo(what, path);
      ASSERT_TRUE(w.waitFor([&] { return w.window->messages().accessibleName().contains("Without a window: "); }));
      QString command = w.window->messages().accessibleName().section("Without a window: ", 1);
      ASSERT_TRUE(command.startsWith("surefoot ")) << command.toStdString();
      command.replace("--minutes 9", "--minutes 0.1").replace(0, 8, SUREFOOT_PROGRAM);
      w.window->messages().dismiss();
      if (command.contains("--resume") && std::string(environment) == "leo") continue;  // ten minutes more take a while
      EXPECT_EQ(std::system(qPrintable(command + " >/dev/null")), 0) << command.toStdString();
    }
  }
}

TEST(MainWindow, ASavedQFunctionIsWhatANewLifeBeginsWith) {
  Window w;
  QTemporaryDir folder;
  const QString path = folder.filePath("q.safetensors");
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().totals.episodes > 300; }));
  w.session->life().setRunning(false);
  w.window->saveTo(SavedAs::QFunction, path);
  ASSERT_TRUE(w.waitFor([&] { return QFile::exists(path); }));
  w.window->openFile(path);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps == 0 && w.session->life().values(); }));
  const auto& q = w.session->life().snapshot().q;
  EXPECT_GT(largest(q), 1.0) << "something is known already";
}

TEST(MainWindow, AJournalIsLivedAgainToTheSameHash) {
  Window w;
  QTemporaryDir folder;
  const QString path = folder.filePath("life.jsonl");
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps > 1000; }));
  ASSERT_TRUE(w.session->editing().setParameter("policy.threshold", 20));
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps > 60'000; }));
  w.session->life().setRunning(false);
  ASSERT_TRUE(w.waitFor([&] { return !w.session->life().snapshot().running; }));
  ASSERT_TRUE(w.session->life().place({0.1, 0.0, 0.0}));
  w.session->looking().stepOnce();
  QTest::qWait(100);
  w.window->saveTo(SavedAs::Journal, path);
  ASSERT_TRUE(w.waitFor([&] { return QFile::exists(path); }));
  const auto journal = readJournal(w.registry, path.toStdString());
  ASSERT_TRUE(journal) << journal.error().message;
  const auto lived = replay(w.registry, *journal, {});
  ASSERT_TRUE(lived) << lived.error().message;
  EXPECT_TRUE(journal->sameAs(*lived));
  EXPECT_EQ(w.session->life().finish()->hash(), lived->hash);
}

TEST(MainWindow, WhatCannotBeOpenedIsSaidInASentence) {
  Window w;
  QTemporaryDir folder;
  for (const char* name : {"nowhere.surefoot", "rubbish.safetensors", "rubbish.jsonl", "rubbish.toml"}) {
    const QString path = folder.filePath(name);
    if (QString(name).startsWith("rubbish")) {
      QFile file(path);
      ASSERT_TRUE(file.open(QIODevice::WriteOnly));
      file.write("{ this is nothing");
    }
    w.window->openFile(path);
    EXPECT_TRUE(w.window->messages().isVisible());
    EXPECT_TRUE(w.window->messages().accessibleName().contains(name))
        << w.window->messages().accessibleName().toStdString();
    w.window->messages().dismiss();
  }
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 1u; })) << "the life goes on";
}

TEST(MainWindow, WhatIsLearnedCanBeCarriedOverIntoOtherTiles) {
  Window w;
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(
      w.waitFor([&] { return w.session->life().snapshot().totals.episodes > 300 && w.session->life().values(); }));
  w.session->life().setRunning(false);
  bool done = false;
  w.session->newLives().carryOver("features.pole_angle", 18, [&](const Status& s) {
    EXPECT_TRUE(s) << s.error().message;
    done = true;
  });
  ASSERT_TRUE(w.waitFor([&] { return done; }, 60'000));
  EXPECT_EQ(w.session->life().configuration().parameters.get("features.pole_angle"), 18);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps == 0 && w.session->life().values(); }));
  const auto& q = w.session->life().snapshot().q;
  EXPECT_GT(largest(q), 1.0);
}

TEST(MainWindow, EveryEnvironmentCanBeChosen) {
  Window w;
  for (const EnvironmentEntry& entry : w.registry.environments) {
    ASSERT_TRUE(w.session->newLives().beginEnvironment(entry.name)) << entry.name;
    ASSERT_TRUE(w.waitFor([&] { return w.session->life().configuration().names.environment == entry.name; }))
        << entry.name;
    w.session->life().setRunning(true);
    ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps > 3 && w.session->life().values(); }))
        << entry.name;
    w.window->grab();
  }
}

TEST(MainWindow, ViewsAreExportedInEveryFormat) {
  Window w;
  QTemporaryDir folder;
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(
      w.waitFor([&] { return w.session->life().snapshot().totals.episodes > 100 && w.session->life().values(); }));
  w.window->livePage().rollOut();  // signals to be exported
  QTest::qWait(200);
  for (Panel* panel : w.window->livePage().panels())
    for (const char* ending : {".png", ".svg", ".pdf", ".csv"}) {
      const std::string path = folder.filePath(panel->objectName() + ending).toStdString();
      const Status s = exportView(*panel->widget(), path);
      const bool walks = panel->objectName() != "strides";  // a pendulum has none
      const bool table = dynamic_cast<CsvSource*>(panel->widget()) != nullptr && walks;
      if (ending != std::string(".csv") || table) {
        EXPECT_TRUE(s) << path;
        EXPECT_GT(QFileInfo(QString::fromStdString(path)).size(), 60) << path;
      } else {
        EXPECT_FALSE(s) << path;
      }
    }
  EXPECT_FALSE(exportView(*w.window, folder.filePath("picture.bmp").toStdString()));
}

TEST(Autosave, ACrashLeavesTheSessionAndAProperEndNothing) {
  Window w;
  QTemporaryDir folder;
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps > 10; }));
  const auto files = [&] { return QDir(folder.path()).entryList({"*.surefoot"}, QDir::Files); };
  Autosave autosave(w.session->life(), w.session->history(), w.session->files(), folder.path());
  autosave.save();
  ASSERT_TRUE(w.waitFor([&] { return files().size() == 1; }));
  EXPECT_TRUE(autosave.leftBehind().isEmpty()) << "its process is alive";
  // A process of that number is alive, but it is another: it holds no lock.
  const QString left = folder.filePath("autosave-1.surefoot");
  ASSERT_TRUE(QFile::rename(folder.filePath(files()[0]), left));
  EXPECT_EQ(autosave.leftBehind(), left);
  bool opened = false;
  w.session->files().open(left.toStdString(), [&](const Status& s) { opened = static_cast<bool>(s); });
  EXPECT_TRUE(w.waitFor([&] { return opened; }));
  autosave.takeOver(left);
  EXPECT_TRUE(w.waitFor([&] { return files().size() == 1 && !QFile::exists(left); }))
      << "gone when there is one of this process, not before";
  autosave.finish();
  EXPECT_TRUE(w.waitFor([&] { return files().isEmpty(); }));
}

TEST(Autosave, AnEndFromOutsideLeavesTheSession) {
  Window w;
  QTemporaryDir folder;
  w.session->looking().stepOnce();
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps == 1; }));
  Autosave autosave(w.session->life(), w.session->history(), w.session->files(), folder.path());
  bool left = false;
  autosave.leave([&](const Status&) { left = true; });
  ASSERT_TRUE(w.waitFor([&] { return left; }));
  autosave.finish();
  EXPECT_EQ(QDir(folder.path()).entryList({"*.surefoot"}, QDir::Files).size(), 1);
}

TEST(MainWindow, WhatIsNoRegularFileIsRefusedAtOnce) {
  Window w;
  QTemporaryDir folder;
  for (const char* name : {"pipe.surefoot", "pipe.sqlite", "pipe.toml"}) {
    const QString pipe = folder.filePath(name);
    ASSERT_EQ(mkfifo(pipe.toUtf8().constData(), 0600), 0);
    w.window->openFile(pipe);
    EXPECT_TRUE(w.window->messages().accessibleName().contains("regular file"))
        << w.window->messages().accessibleName().toStdString();
    w.window->messages().dismiss();
  }
}

}  // namespace surefoot
