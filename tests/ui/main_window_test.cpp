// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDialog>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <cmath>

#include "core/experiment/journal.h"

#include "tests/ui/window_setup.h"
#include "ui/autosave.h"
#include "ui/exporting.h"
#include "ui/live_page.h"
#include "ui/message_bar.h"
#include "ui/panel.h"
#include "ui/parameter_row.h"
#include "ui/slider.h"
#include "ui/theme.h"

namespace surefoot {

namespace {
double largest(const std::vector<double>& q) {
  double most = 0;
  for (const double v : q) most = std::max(most, std::abs(v));
  return most;
}
}  // namespace

TEST(MainWindow, SpaceRunsAndPauses) {
  Window w;
  w.key(Qt::Key_Space);
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().steps > 10; }));
  w.key(Qt::Key_Space);
  EXPECT_FALSE(w.session->running());
}

TEST(MainWindow, PointAndRightDoOneStep) {
  Window w;
  w.key(Qt::Key_Period);
  w.key(Qt::Key_Right);
  EXPECT_TRUE(w.waitFor([&] { return w.session->snapshot().steps == 2; }));
}

TEST(MainWindow, TIsTurboAndRRestarts) {
  Window w;
  w.key(Qt::Key_T);
  EXPECT_TRUE(w.session->turbo());
  w.key(Qt::Key_Space);
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().steps > 100'000; }));
  w.key(Qt::Key_R);
  EXPECT_TRUE(w.waitFor([&] { return w.session->snapshot().life == 2; }));
  w.key(Qt::Key_T);
  EXPECT_FALSE(w.session->turbo());
}

TEST(MainWindow, PlusAndMinusChangeThePace) {
  Window w;
  w.key(Qt::Key_Plus);
  EXPECT_GT(w.session->pace(), 1.0);
  w.key(Qt::Key_Minus);
  w.key(Qt::Key_Minus);
  EXPECT_LT(w.session->pace(), 1.0);
}

TEST(MainWindow, TheToolbarsButtonsDoWhatTheShortcutsDo) {
  Window w;
  QTest::mouseClick(w.named<QAbstractButton>("Run"), Qt::LeftButton);
  EXPECT_TRUE(w.session->running());
  QTest::mouseClick(w.named<QAbstractButton>("Pause"), Qt::LeftButton);
  EXPECT_FALSE(w.session->running());
  QTest::mouseClick(w.named<QAbstractButton>("Step"), Qt::LeftButton);
  QTest::mouseClick(w.named<QAbstractButton>("Restart"), Qt::LeftButton);
  EXPECT_TRUE(w.waitFor([&] { return w.session->snapshot().life == 2; }));
  QTest::mouseClick(w.named<QAbstractButton>("Turbo"), Qt::LeftButton);
  EXPECT_TRUE(w.session->turbo());
  w.named<Slider>("Pace")->setValue(Slider::kSteps);
  EXPECT_NEAR(w.session->pace(), 8.0, 1e-9);
}

TEST(MainWindow, PolicyAndScenarioAreChosenInTheToolbar) {
  Window w;
  auto* policy = w.named<QComboBox>("Policy");
  const int softmax = policy->findData("softmax");
  ASSERT_GE(softmax, 0);
  Q_EMIT policy->activated(softmax);
  EXPECT_EQ(w.session->configuration().names.policy, "softmax");
  auto* scenario = w.named<QComboBox>("Scenario");
  Q_EMIT scenario->activated(scenario->findData("3"));
  EXPECT_EQ(w.session->configuration().parameters.get("environment.friction"), 0.05);
  EXPECT_EQ(w.session->configuration().names.scenario, "3");
}

TEST(MainWindow, AnotherLearningRuleStartsAgainAndShowsItsParts) {
  Window w;
  auto* agent = w.named<QComboBox>("Learning rule");
  Q_EMIT agent->activated(agent->findData("sarsa-2q"));
  EXPECT_EQ(w.session->configuration().names.agent, "sarsa") << "not before it is agreed to";
  ASSERT_TRUE(w.window->messages().isVisible());
  for (auto* button : w.window->messages().findChildren<QPushButton*>())
    if (button->text() == "Start again") QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(w.session->configuration().names.agent, "sarsa-2q");
  w.session->setTurbo(true);
  w.session->setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->values() && w.session->shown().qNegative.size() == 5; }));
  for (std::size_t a = 0; a < 5; ++a)
    EXPECT_NEAR(w.session->shown().q[a], w.session->shown().qPositive[a] + w.session->shown().qNegative[a], 1e-9);
  std::set<std::string> rows;
  for (const ParameterRow* row : w.window->findChildren<ParameterRow*>()) rows.insert(row->key());
  EXPECT_TRUE(rows.contains("negative.scale"));
  EXPECT_FALSE(rows.contains("agent.step_size"));
}

TEST(MainWindow, EveryMenuEntryCanBeTriggered) {
  Window w;
  w.session->setRunning(true);
  int triggered = 0;
  for (const QAction* menu : w.window->menuBar()->actions())
    for (QAction* action : menu->menu()->actions()) {
      if (action->isSeparator() || action->text().contains("Quit")) continue;
      action->trigger();
      QTest::qWait(20);
      for (auto* dialog : w.window->findChildren<QDialog*>()) dialog->close();
      if (action->isCheckable() && !action->actionGroup()) action->trigger();  // and back
      ++triggered;
    }
  EXPECT_GE(triggered, 15);
  applyAppearance(*qApp, Appearance::Light);
}

TEST(MainWindow, ThePagesThatAreNotThereYetSaySo) {
  Window w;
  QTest::mouseClick(w.named<QAbstractButton>("Experiment"), Qt::LeftButton);
  EXPECT_FALSE(w.window->livePage().isVisible());
  QTest::mouseClick(w.named<QAbstractButton>("Lessons"), Qt::LeftButton);
  QTest::mouseClick(w.named<QAbstractButton>("Live"), Qt::LeftButton);
  EXPECT_TRUE(w.window->livePage().isVisible());
}

TEST(MainWindow, APanelTakesTheWholePageAndGivesItBack) {
  Window w;
  Panel* maps = w.window->findChild<Panel*>("maps");
  const QSize before = maps->size();
  Q_EMIT maps->header().fullSizeAsked();
  EXPECT_TRUE(w.waitFor([&] { return maps->width() > 1000; }));
  EXPECT_FALSE(w.window->findChild<Panel*>("falls")->isVisible());
  Q_EMIT maps->header().fullSizeAsked();
  EXPECT_TRUE(w.waitFor([&] { return maps->size() == before; }));
  EXPECT_TRUE(w.window->findChild<Panel*>("falls")->isVisible());
}

TEST(MainWindow, FollowsTheThemeEverywhere) {
  Window w;
  w.session->setTurbo(true);
  w.session->setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().totals.episodes > 50; }));
  applyAppearance(*qApp, Appearance::Dark);
  QTest::qWait(300);
  const QImage image = w.window->grab().toImage();
  int light = 0;
  for (int y = 0; y < image.height(); y += 4)
    for (int x = 0; x < image.width(); x += 4) light += qGray(image.pixel(x, y)) > 200;
  applyAppearance(*qApp, Appearance::Light);
  EXPECT_LT(light, image.width() * image.height() / 16 / 10) << "less than a tenth of a dark window is light";
}

TEST(MainWindow, EveryControlHasANameForScreenReaders) {
  Window w;
  for (const QWidget* widget : w.window->findChildren<QWidget*>()) {
    const bool control =
        widget->focusPolicy() != Qt::NoFocus && widget->isVisible() && widget->isEnabled() && !widget->focusProxy();
    if (!control || widget->inherits("QScrollArea") || widget->inherits("QMenuBar")) continue;
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->metaObject()->className();
  }
}

TEST(MainWindow, RemembersItsLayout) {
  QByteArray saved;
  {
    Window w;
    w.window->findChild<Panel*>("falls")->hide();
    w.window->close();
    saved = QSettings().value("layout").toByteArray();
    EXPECT_FALSE(saved.isEmpty());
  }
  {
    Window w;
    EXPECT_FALSE(w.window->findChild<Panel*>("falls")->isVisible());
  }
  QSettings().clear();
}

TEST(MainWindow, NoPanelIsCutAtItsSmallestSize) {
  Window w;
  for (const Panel* panel : w.window->livePage().panels()) {
    EXPECT_GE(panel->widget()->width(), panel->widget()->minimumSizeHint().width())
        << panel->objectName().toStdString();
    EXPECT_GE(panel->widget()->height(), panel->widget()->minimumSizeHint().height())
        << panel->objectName().toStdString();
  }
}

TEST(MainWindow, UndoTakesAChangeBackAndRedoMakesItAgain) {
  Window w;
  const auto temperature = [&] { return w.session->configuration().parameters.get("policy.temperature"); };
  const double before = temperature();
  ASSERT_TRUE(w.session->setParameter("policy.temperature", 4.0));
  QTest::keyClick(w.window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(temperature(), before);
  QTest::keyClick(w.window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(temperature(), 4.0);
}

TEST(MainWindow, ASavedSessionGoesOnWhereItWas) {
  Window w;
  QTemporaryDir folder;
  const QString path = folder.filePath("one.surefoot");
  w.session->setTurbo(true);
  w.session->setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().totals.episodes > 100; }));
  w.session->setRunning(false);
  ASSERT_TRUE(w.waitFor([&] { return !w.session->snapshot().running; }));
  w.window->saveTo(SavedAs::Session, path);
  ASSERT_TRUE(w.waitFor([&] { return QFile::exists(path); }));
  QTest::qWait(50);
  const auto before = w.session->snapshot().totals;
  const std::int64_t steps = w.session->snapshot().steps;
  ASSERT_TRUE(w.session->restart());
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().steps == 0; }));
  w.window->openFile(path);
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().steps == steps; }));
  EXPECT_EQ(w.session->snapshot().totals.episodes, before.episodes);
  EXPECT_EQ(w.session->snapshot().totals.falls, before.falls);
  EXPECT_EQ(w.window->windowTitle(), "Surefoot: one");
}

TEST(MainWindow, ASavedQFunctionIsWhatANewLifeBeginsWith) {
  Window w;
  QTemporaryDir folder;
  const QString path = folder.filePath("q.safetensors");
  w.session->setTurbo(true);
  w.session->setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().totals.episodes > 300; }));
  w.session->setRunning(false);
  w.window->saveTo(SavedAs::QFunction, path);
  ASSERT_TRUE(w.waitFor([&] { return QFile::exists(path); }));
  w.window->openFile(path);
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().steps == 0 && w.session->values(); }));
  const auto& q = w.session->snapshot().q;
  EXPECT_GT(largest(q), 1.0) << "something is known already";
}

TEST(MainWindow, AJournalIsLivedAgainToTheSameHash) {
  Window w;
  QTemporaryDir folder;
  const QString path = folder.filePath("life.jsonl");
  w.session->setTurbo(true);
  w.session->setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().steps > 1000; }));
  ASSERT_TRUE(w.session->setParameter("policy.threshold", 20));
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().steps > 60'000; }));
  w.session->setRunning(false);
  ASSERT_TRUE(w.waitFor([&] { return !w.session->snapshot().running; }));
  ASSERT_TRUE(w.session->place({0.1, 0.0, 0.0}));
  w.session->stepOnce();
  QTest::qWait(100);
  w.window->saveTo(SavedAs::Journal, path);
  ASSERT_TRUE(w.waitFor([&] { return QFile::exists(path); }));
  const auto journal = readJournal(w.registry, path.toStdString());
  ASSERT_TRUE(journal) << journal.error().message;
  const auto lived = replay(w.registry, *journal, {});
  ASSERT_TRUE(lived) << lived.error().message;
  EXPECT_TRUE(journal->sameAs(*lived));
  EXPECT_EQ(w.session->finish()->hash(), lived->hash);
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
  EXPECT_EQ(w.session->snapshot().life, 1u) << "the life goes on";
}

TEST(MainWindow, WhatIsLearnedCanBeCarriedOverIntoOtherTiles) {
  Window w;
  w.session->setTurbo(true);
  w.session->setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().totals.episodes > 300 && w.session->values(); }));
  w.session->setRunning(false);
  bool done = false;
  w.session->carryOver("features.pole_angle", 18, [&](const Status& s) {
    EXPECT_TRUE(s) << s.error().message;
    done = true;
  });
  ASSERT_TRUE(w.waitFor([&] { return done; }, 60'000));
  EXPECT_EQ(w.session->configuration().parameters.get("features.pole_angle"), 18);
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().steps == 0 && w.session->values(); }));
  const auto& q = w.session->snapshot().q;
  EXPECT_GT(largest(q), 1.0);
}

TEST(MainWindow, EveryEnvironmentCanBeChosen) {
  Window w;
  for (const EnvironmentEntry& entry : w.registry.environments) {
    ASSERT_TRUE(w.session->beginEnvironment(entry.name)) << entry.name;
    w.session->setRunning(true);
    ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().steps > 3 && w.session->values(); })) << entry.name;
    w.window->grab();
    EXPECT_EQ(w.session->configuration().names.environment, entry.name);
  }
}

TEST(MainWindow, ViewsAreExportedInEveryFormat) {
  Window w;
  QTemporaryDir folder;
  w.session->setTurbo(true);
  w.session->setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().totals.episodes > 100 && w.session->values(); }));
  QTest::qWait(200);
  for (Panel* panel : w.window->livePage().panels())
    for (const char* ending : {".png", ".svg", ".pdf", ".csv"}) {
      const std::string path = folder.filePath(panel->objectName() + ending).toStdString();
      const Status s = exportView(*panel->widget(), path);
      const bool table = dynamic_cast<CsvSource*>(panel->widget()) != nullptr;
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
  w.session->setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->snapshot().steps > 10; }));
  const auto files = [&] { return QDir(folder.path()).entryList(QDir::Files); };
  Autosave autosave(*w.session, folder.path());
  autosave.save();
  ASSERT_TRUE(w.waitFor([&] { return files().size() == 1; }));
  EXPECT_TRUE(autosave.leftBehind().isEmpty()) << "its process is alive";
  ASSERT_TRUE(QFile::rename(folder.filePath(files()[0]), folder.filePath("autosave-999999999.surefoot")));
  EXPECT_FALSE(autosave.leftBehind().isEmpty());
  EXPECT_TRUE(w.session->open(autosave.leftBehind().toStdString()));
  autosave.forget();
  EXPECT_TRUE(files().isEmpty());
  QTest::qWait(50);
  autosave.save();
  autosave.finish();
  QTest::qWait(100);
}

}  // namespace surefoot
