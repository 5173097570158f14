// SPDX-License-Identifier: GPL-3.0-or-later
// Every bad file that was worth keeping, opened in the window: it is shown or told, and the life goes on.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include "tests/ui/window_setup.h"
#include "ui/controls/message_bar.h"
#include "ui/experiment/experiment_page.h"

namespace surefoot {

namespace {

/// Copies of the files of a folder of the corpus, with an ending.
QStringList copies(const char* folder, const QTemporaryDir& to, const QString& ending) {
  QStringList paths;
  const QDir from(QStringLiteral(SUREFOOT_SOURCE "/tests/fuzz/") + folder);
  for (const QString& name : from.entryList(QDir::Files)) {
    paths << to.filePath(name + ending);
    EXPECT_TRUE(QFile::copy(from.filePath(name), paths.back()));
  }
  EXPECT_GT(paths.size(), 10);
  return paths;
}

}  // namespace

TEST(CorpusInTheWindow, SessionsAndQFunctions) {
  Window w;
  const QTemporaryDir folder;
  for (const QString& path : copies("corpus", folder, ".surefoot")) {
    w.window->openFile(path);
    ASSERT_TRUE(w.waitFor([&] { return !w.session->newLives().background().busy(); })) << path.toStdString();
    QTest::qWait(5);
    while (w.window->messages().cancel()) {
    }
  }
  const auto steps = w.session->life().snapshot().steps;
  w.session->life().setRunning(true);
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps != steps; }));
}

TEST(CorpusInTheWindow, PlansAndStores) {
  Window w;
  const QTemporaryDir folder;
  w.window->setPage(1);
  Experiment& experiment = w.window->experimentPage().experiment();
  for (const QString& path : copies("texts", folder, ".toml") + copies("stores", folder, ".sqlite")) {
    w.window->experimentPage().open(path);
    ASSERT_TRUE(w.waitFor([&] { return !experiment.isOpening(); })) << path.toStdString();
    QTest::qWait(5);
    while (w.window->messages().cancel()) {
    }
  }
  const auto steps = w.session->life().snapshot().steps;
  w.session->life().setRunning(true);
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps != steps; }));
}

}  // namespace surefoot
