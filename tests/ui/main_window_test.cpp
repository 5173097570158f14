// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDialog>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>

#include "tests/ui/window_setup.h"
#include "ui/live_page.h"
#include "ui/message_bar.h"
#include "ui/panel.h"
#include "ui/parameter_row.h"
#include "ui/slider.h"
#include "ui/theme.h"

namespace surefoot {

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

}  // namespace surefoot
