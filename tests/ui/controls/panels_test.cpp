// SPDX-License-Identifier: GPL-3.0-or-later
// The toolbar and the heads of panels where there is little room, panels that float, what a replay is steered by.
#include "ui/controls/panel.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

#include "core/lessons/reading/step_reading.h"
#include "tests/ui/pixels_of.h"
#include "tests/ui/window_setup.h"
#include "ui/live/live_page.h"
#include "ui/live/maps/map_bar.h"
#include "ui/live/run_bar.h"
#include "ui/live/world/scrubber.h"
#include "ui/live/world/world_view.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {}  // namespace

TEST(MapBar, FoldsIntoOneMenuWithTheSameChoices) {
  Window w;
  MapBar bar;
  MapChoice choice;
  choice.fit(w.session->life().task());
  const std::vector<double> live(3, 0.0);
  bar.show(choice, w.session->life().task(), live, false);
  const auto visible = [&] {
    QList<QToolButton*> list;
    for (QToolButton* b : bar.findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly))
      if (!b->isHidden()) list << b;
    return list;
  };
  bar.fold(600);
  EXPECT_EQ(visible().size(), 4);
  bar.fold(120);
  ASSERT_EQ(visible().size(), 1);
  QMenu* menu = visible().front()->menu();
  Q_EMIT menu->aboutToShow();
  ASSERT_EQ(menu->actions().size(), 4);
  for (QAction* part : menu->actions()) {
    ASSERT_TRUE(part->menu()) << part->text().toStdString();
    EXPECT_GE(part->menu()->actions().size(), 2) << part->text().toStdString();
  }
}

TEST(RunBar, TheNumberOfFallsIsThereHoweverNarrow) {
  Window w;
  auto* bar = w.window->findChild<RunBar*>();
  const auto falls = [&](int width) {
    bar->resize(width, bar->height());
    const QImage image = bar->grab().toImage();
    return pixelsOf(image, lightTheme().fallText);
  };
  const int whole = falls(1280);
  EXPECT_GT(whole, 10);
  for (const int width : {1120, 1024, 900, 760, 640, 560}) {
    EXPECT_EQ(falls(width), whole) << width;
    const auto* policy = w.named<QComboBox>("Policy");
    EXPECT_LT(policy->geometry().right(), width) << width;
    EXPECT_GE(policy->width(), 48);
  }
}

TEST(RunBar, TasksAndScenariosStandUnderHeads) {
  Window w;
  auto* task = w.named<QComboBox>("Task");
  QStringList heads;
  for (int i = 0; i < task->count(); ++i)
    if (!(task->model()->flags(task->model()->index(i, 0)) & Qt::ItemIsEnabled)) heads << task->itemText(i);
  EXPECT_EQ(heads, (QStringList{"Scenario of the model", "Task"}));
  EXPECT_LT(task->findText("Scenario of the model"), task->findData("actual"));
  EXPECT_LT(task->findText("Task"), task->findData("leo"));
}

TEST(LivePage, ATaskWithoutFallsShowsNone) {
  Elsewhere w("mountain-car");
  for (Panel* panel : w.window->livePage().panels())
    if (panel->objectName() == "falls" || panel->objectName() == "list") {
      EXPECT_FALSE(panel->isVisible());
      EXPECT_FALSE(panel->toggleViewAction()->isEnabled());
    }
  const QImage bar = w.window->findChild<RunBar*>()->grab().toImage();
  EXPECT_EQ(pixelsOf(bar, lightTheme().fallText), 0);
  ASSERT_TRUE(w.session->newLives().beginEnvironment("cliff"));
  EXPECT_TRUE(w.waitFor([&] {
    for (Panel* panel : w.window->livePage().panels())
      if (panel->objectName() == "falls") return panel->isVisible();
    return false;
  }));
}

TEST(Scrubber, PlaysAndStopsAndTakesNoRoomOfTheWorld) {
  Window w("epsilon-greedy");
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return !w.session->looking().falls().empty(); }, 30'000));
  w.session->life().setRunning(false);
  const QSize size = w.window->livePage().world().size();
  w.session->looking().replayFall(0);
  ASSERT_TRUE(w.session->looking().playback());
  auto* scrubber = w.window->findChild<Scrubber*>();
  QTest::qWait(50);
  EXPECT_EQ(w.window->livePage().world().size(), size);
  EXPECT_GT(scrubber->width(), 100);
  auto* play = scrubber->findChildren<QToolButton*>().front();
  QTest::mouseClick(play, Qt::LeftButton);
  EXPECT_EQ(w.session->looking().playback()->rate, 0);
  EXPECT_EQ(play->text(), "Play");
  QTest::mouseClick(play, Qt::LeftButton);
  EXPECT_GT(w.session->looking().playback()->rate, 0);
  w.session->looking().backToLive();
  EXPECT_EQ(scrubber->width(), 0);
}

TEST(Panel, OneThatFloatsCanBeClosed) {
  Window w;
  Panel* panel = w.window->livePage().panels().back();
  panel->show();
  panel->setFloating(true);
  auto* close = panel->header().findChildren<QAbstractButton*>().front();
  EXPECT_TRUE(close->isVisible());
  QTest::mouseClick(close, Qt::LeftButton);
  EXPECT_FALSE(panel->isVisible());
  panel->setFloating(false);
  EXPECT_TRUE(close->isHidden());
}

// A lesson names the panels that it shows.
TEST(Panels, LessonsKnowEveryPanelOfTheLivePage) {
  Window w;
  const auto& known = lessonPanels();
  for (const Panel* panel : w.window->findChildren<Panel*>())
    EXPECT_TRUE(std::find(known.begin(), known.end(), panel->objectName().toStdString()) != known.end())
        << panel->objectName().toStdString();
}

TEST(PanelHeader, FollowsAWidgetWhoseFontChanges) {
  PanelHeader header(QStringLiteral("Description"), false);
  auto* label = new QLabel(QStringLiteral("1 error"));
  header.addWidget(label);
  header.resize(400, 32);
  header.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&header));
  QFont font = label->font();
  font.setPixelSize(24);
  label->setFont(font);
  QTest::qWait(20);
  EXPECT_EQ(label->size(), label->sizeHint());
  EXPECT_LE(label->geometry().right(), header.rect().right());
}

}  // namespace surefoot
