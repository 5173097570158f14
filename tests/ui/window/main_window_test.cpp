// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTableWidget>

#include "tests/ui/window_setup.h"
#include "ui/controls/panel.h"
#include "ui/controls/preferences.h"
#include "ui/live/live_page.h"
#include "ui/style/theme.h"

namespace surefoot {

TEST(MainWindow, SpaceRunsAndPauses) {
  Window w;
  w.key(Qt::Key_Space);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps > 10; }));
  w.key(Qt::Key_Space);
  EXPECT_FALSE(w.session->life().running());
}

TEST(MainWindow, PointAndRightDoOneStep) {
  Window w;
  w.key(Qt::Key_Period);
  w.key(Qt::Key_Right);
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps == 2; }));
}

TEST(MainWindow, TIsTurboAndRRestarts) {
  Window w;
  w.key(Qt::Key_T);
  EXPECT_TRUE(w.session->life().turbo());
  w.key(Qt::Key_Space);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps > 100'000; }));
  w.key(Qt::Key_R);
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 2; }));
  w.key(Qt::Key_T);
  EXPECT_FALSE(w.session->life().turbo());
}

TEST(MainWindow, PlusAndMinusChangeThePace) {
  Window w;
  w.key(Qt::Key_Plus);
  EXPECT_GT(w.session->life().pace(), 1.0);
  w.key(Qt::Key_Minus);
  w.key(Qt::Key_Minus);
  EXPECT_LT(w.session->life().pace(), 1.0);
}

TEST(MainWindow, EveryMenuEntryCanBeTriggered) {
  Window w;
  w.session->life().setRunning(true);
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
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().totals.episodes > 50; }));
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
  const auto temperature = [&] { return w.session->life().configuration().parameters.get("policy.temperature"); };
  const double before = temperature();
  ASSERT_TRUE(w.session->editing().setParameter("policy.temperature", 4.0));
  QTest::keyClick(w.window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(temperature(), before);
  QTest::keyClick(w.window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(temperature(), 4.0);
}

TEST(MainWindow, APoolIsLearnedInSimulationAndOneOfItLivesInReality) {
  Window w("epsilon-greedy");
  ASSERT_TRUE(w.session->editing().setParameter("life.rewind", 20.0));
  w.key(Qt::Key_P);
  auto* dialog = w.window->findChild<QDialog*>();
  ASSERT_TRUE(dialog);
  const auto field = [&](const char* name) { return w.named<QLineEdit>(name); };
  EXPECT_EQ(field("Damping in simulation")->text(), "0.04") << "scenario 2";
  EXPECT_EQ(field("Damping in reality")->text(), "0.08");
  field("Average reward that ends the pre-learning")->setText("-80");
  w.named<QSpinBox>("Q-functions to learn")->setValue(2);
  auto* table = w.named<QTableWidget>("The pool");
  const auto press = [&](const char* text) {
    for (auto* button : dialog->findChildren<QPushButton*>())
      if (button->text() == text) return QTest::mouseClick(button, Qt::LeftButton);
    ADD_FAILURE() << text;
  };
  field("Damping in simulation")->setText("7000");
  press("Pre-learn");
  EXPECT_EQ(table->rowCount(), 0) << "it is out of range, and nothing begins";
  field("Damping in simulation")->setText("0.04");
  press("Pre-learn");
  ASSERT_TRUE(w.waitFor([&] { return table->rowCount() == 2; }, 60'000));
  EXPECT_NE(table->item(0, 2)->text() + table->item(0, 1)->text(),
            table->item(1, 2)->text() + table->item(1, 1)->text())
      << "each with random numbers of its own";
  field("Damping in reality")->setText("0.07");
  press("Begin a life in reality with it");
  EXPECT_EQ(w.session->life().configuration().parameters.get("environment.damping"), 0.07);
  ASSERT_TRUE(w.session->life().configuration().start) << "it began with what was learned";
  EXPECT_GT(w.session->life().configuration().start->about["learned"]["rewinds"], 0);
  EXPECT_EQ(w.session->life().configuration().parameters.get("life.rewind"), 0.0) << "reality does not go back";
}

TEST(MainWindow, PreferencesAreKeptAndApplyAtOnce) {
  {
    Window w;
    PreferencesDialog dialog(w.window.get());
    for (auto* box : dialog.findChildren<QCheckBox*>())
      if (box->text().startsWith("less of it")) box->setChecked(true);
    EXPECT_TRUE(reducedMotion());
  }
  EXPECT_TRUE(readPreferences().reduceMotion);
  EXPECT_TRUE(readPreferences().beginRunning);
  QSettings().setValue("autosaveMinutes", -5);
  QSettings().setValue("appearance", 99);
  EXPECT_EQ(readPreferences().autosaveMinutes, 1) << "whatever stands in the file";
  EXPECT_EQ(readPreferences().appearance, Appearance::Dark);
  QSettings().clear();
  readPreferences();
}

TEST(MainWindow, LayoutsAreKeptUnderNames) {
  Window w;
  const auto choose = [&](const QString& text) {
    for (auto* action : w.window->findChildren<QAction*>())
      if (action->text() == text) return action->trigger();
    ADD_FAILURE() << text.toStdString();
  };
  const auto own = [&]() -> QMenu* {
    for (auto* menu : w.window->findChildren<QMenu*>())
      if (menu->title() == "&My own") {
        Q_EMIT menu->aboutToShow();
        return menu;
      }
    return nullptr;
  };
  EXPECT_FALSE(own()->actions().front()->isEnabled()) << "none kept yet";
  w.window->findChild<Panel*>("falls")->hide();
  choose("&Keep this one as …");
  auto* dialog = w.window->findChild<QInputDialog*>();
  ASSERT_TRUE(dialog);
  dialog->setTextValue("mine / yours");
  dialog->accept();
  choose("&Usual");
  EXPECT_TRUE(w.window->findChild<Panel*>("falls")->isVisible());
  ASSERT_EQ(own()->actions().front()->text(), "mine / yours");
  own()->actions().front()->trigger();
  EXPECT_FALSE(w.window->findChild<Panel*>("falls")->isVisible());
  QSettings().clear();
}

}  // namespace surefoot
