// SPDX-License-Identifier: GPL-3.0-or-later
#include <QImage>

#include "tests/ui/pixels_of.h"
#include "tests/ui/window_setup.h"
#include "ui/live/actions/action_rows.h"
#include "ui/live/charts/learning_charts.h"
#include "ui/live/maps/value_maps.h"
#include "ui/live/world/world_view.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

/// A window whose learner has run for a while and is paused.
struct Learned : Window {
  Learned() : Window("trl") {
    session->life().setTurbo(true);
    session->life().setRunning(true);
    EXPECT_TRUE(waitFor([&] { return session->life().snapshot().totals.episodes > 300 && session->life().values(); }));
    session->life().setRunning(false);
    QTest::qWait(250);
  }
  template <class W>
  QImage picture() {
    return window->findChild<W*>()->grab().toImage();
  }
};

}  // namespace

TEST(WorldView, MovesWhileTheLearnerRunsAndRestsWhileItIsPaused) {
  Learned w;
  const QImage one = w.picture<WorldView>();
  QTest::qWait(400);  // until the trail has faded
  const QImage two = w.picture<WorldView>();
  QTest::qWait(200);
  EXPECT_EQ(two, w.picture<WorldView>());
  w.session->life().setRunning(true);
  EXPECT_TRUE(w.waitFor([&] { return w.picture<WorldView>() != two; }));
}

TEST(WorldView, ShowsTheFallZoneInTheColourOfFalling) {
  Learned w;
  EXPECT_GT(pixelsOf(w.picture<WorldView>(), lightTheme().fall), 20);
}

TEST(ActionRows, DrawTheBarsOfThePolicyInForceInItsColour) {
  Learned w;
  EXPECT_GT(pixelsOf(w.picture<ActionRows>(), lightTheme().trl), 200);
}

TEST(ActionRows, TheThresholdIsALineToDrag) {
  Learned w;
  auto* rows = w.window->findChild<ActionRows*>();
  const QImage image = rows->grab().toImage();
  int x = -1;  // the dashed line: TRL's colour above the first row
  for (int column = 70; column < image.width() / 2 && x < 0; ++column)
    for (int y = 30; y < 60; ++y)
      if (image.pixelColor(column, y) == lightTheme().trl) x = column;
  ASSERT_GE(x, 0);
  QTest::mousePress(rows, Qt::LeftButton, {}, {x, 100});
  QTest::mouseMove(rows, {x + 30, 100});
  QTest::mouseRelease(rows, Qt::LeftButton, {}, {x + 30, 100});
  const double threshold = w.session->life().configuration().parameters.get("policy.threshold");
  EXPECT_GT(threshold, 80);
  EXPECT_LT(threshold, 200);
}

// LEO's 343 actions: three joints of seven levels.
TEST(ActionRows, ShowCombinationsByTheirVariables) {
  Window w;
  ASSERT_TRUE(w.session->newLives().beginEnvironment("leo"));
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 2 && w.session->life().values(); }, 30'000));
  auto* rows = w.window->findChild<ActionRows*>();
  ASSERT_TRUE(w.waitFor([&] { return rows->asCsv().starts_with("action,stance_hip_voltage,swing_hip_voltage,"); }));
  const std::string csv = rows->asCsv();
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 344);
  const QImage picture = rows->grab().toImage();
  int bars = 0;
  for (int y = 0; y < picture.height(); ++y) bars += picture.pixelColor(68, y) == lightTheme().trl;
  EXPECT_GT(bars, 7 * 6) << "a bar a level, of the policy in force";

  auto* maps = w.window->findChild<ValueMaps*>();
  EXPECT_FALSE(maps->choice().locked) << "the reward of 25 s is no scale for values";
  MapChoice choice = maps->choice();
  choice.quantity = MapQuantity::GreedyAction;
  choice.action = 2;
  maps->setChoice(choice);
  EXPECT_TRUE(quantityText(choice, w.session->life().task()).contains("swing knee"));
  EXPECT_EQ(greedyValues(choice, w.session->life().task()), 7u);
}

// Both have two state variables, but not as many actions.
TEST(ValueMaps, WhatWasChosenForOneEnvironmentIsNotTakenToAnother) {
  Window w;
  ASSERT_TRUE(w.session->newLives().beginEnvironment("grid-world"));
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().task().actions.size() == 4; }));
  auto* maps = w.window->findChild<ValueMaps*>();
  MapChoice last = maps->choice();
  last.quantity = MapQuantity::OneAction;
  last.action = 3;
  maps->setChoice(last);
  EXPECT_EQ(maps->choice().action, 3);
  ASSERT_TRUE(w.session->newLives().beginEnvironment("mountain-car"));
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().task().actions.size() == 3; }));
  EXPECT_EQ(maps->choice().quantity, MapQuantity::BestAction);
  maps->setChoice(last);  // from a menu that is still open
  EXPECT_EQ(maps->choice().quantity, MapQuantity::BestAction);
}

TEST(ValueMaps, ShowLearnedValuesAndHatchTheRest) {
  Learned w;
  const QImage image = w.picture<ValueMaps>();
  int panel = 0, other = 0;  // upper left, where no pole ever is: the panel's colour between the lines of the hatching
  for (int y = 28; y < 60; ++y)
    for (int x = 50; x < 82; ++x) ++(image.pixelColor(x, y) == lightTheme().panel ? panel : other);
  EXPECT_GT(panel, 200);
  EXPECT_GT(other, 100);
  QSet<QRgb> colours;
  for (int y = 30; y < 200; ++y)
    for (int x = 50; x < 230; ++x) colours.insert(image.pixel(x, y));
  EXPECT_GT(colours.size(), 100);
}

TEST(ValueMaps, OfAPausedLifeChangeWithTheTheme) {
  Learned w;
  const auto bright = [&] {  // where a value near 0 stands: white in the light, dark in the dark
    const QImage image = w.picture<ValueMaps>();
    int count = 0;
    for (int y = 30; y < 200; ++y)
      for (int x = 50; x < 230; ++x) count += qGray(image.pixel(x, y)) > 200;
    return count;
  };
  const int light = bright();
  applyAppearance(*qApp, Appearance::Dark);
  QTest::qWait(50);
  const int dark = bright();
  applyAppearance(*qApp, Appearance::Light);
  QTest::qWait(50);
  EXPECT_GT(light, 1000);
  EXPECT_LT(dark, light / 5);
  EXPECT_EQ(bright(), light);
}

TEST(ValueMaps, TheCursorShowsWhatTheRobotWouldDoThere) {
  Learned w;
  auto* maps = w.window->findChild<ValueMaps*>();
  QTest::mouseMove(maps, {140, 110});
  ASSERT_TRUE(w.waitFor([&] { return !w.session->looking().examined().empty(); }));
  EXPECT_TRUE(maps->spoken().contains("α")) << maps->spoken().toStdString();
  EXPECT_EQ(maps->accessibleDescription(), maps->spoken());
  QTest::mousePress(maps, Qt::LeftButton, Qt::ShiftModifier, {140, 110});
  QTest::mouseMove(maps, {4, 4});
  EXPECT_TRUE(w.session->looking().pinned());
  QTest::keyClick(maps, Qt::Key_Escape);
  EXPECT_TRUE(w.session->looking().examined().empty());
}

TEST(ValueMaps, TheKeyboardMovesTheCursor) {
  Learned w;
  auto* maps = w.window->findChild<ValueMaps*>();
  maps->setFocus();
  const std::int64_t steps = w.session->life().snapshot().steps;
  QTest::keyClick(maps, Qt::Key_Right);
  ASSERT_FALSE(w.session->looking().examined().empty());
  const auto first = w.session->looking().examined();
  QTest::keyClick(maps, Qt::Key_Right);
  QTest::keyClick(maps, Qt::Key_Up);
  EXPECT_GT(w.session->looking().examined()[0], first[0]);
  EXPECT_GT(w.session->looking().examined()[1], first[1]);
  EXPECT_DOUBLE_EQ(w.session->looking().examined()[2], first[2]);
  QTest::qWait(100);
  EXPECT_EQ(w.session->life().snapshot().steps, steps) << "the arrow is no single step here";
}

TEST(ValueMaps, AClickPutsThePausedBodyIntoThatState) {
  Learned w;
  auto* maps = w.window->findChild<ValueMaps*>();
  const std::int64_t episodes = w.session->life().snapshot().totals.episodes;
  QTest::mouseMove(maps, {140, 110});
  ASSERT_TRUE(w.waitFor([&] { return !w.session->looking().examined().empty(); }));
  const auto state = w.session->looking().examined();
  QTest::mouseClick(maps, Qt::LeftButton, {}, {140, 110});
  ASSERT_TRUE(w.waitFor([&] { return std::abs(w.session->life().snapshot().state[0] - state[0]) < 1e-6; }));
  EXPECT_NEAR(w.session->life().snapshot().state[1], state[1], 1e-5);
  EXPECT_EQ(w.session->life().snapshot().totals.episodes, episodes) << "the episode given up is not counted";
}

TEST(ValueMaps, EveryQuantityAndEveryPairOfAxesCanBeShown) {
  Learned w;
  auto* maps = w.window->findChild<ValueMaps*>();
  QSet<QByteArray> pictures;
  for (const MapQuantity quantity : {MapQuantity::BestAction, MapQuantity::OneAction, MapQuantity::GreedyAction,
                                     MapQuantity::Visits, MapQuantity::Eligibility})
    for (const auto& [x, y] : {std::pair{0, 1}, {1, 0}, {2, 0}, {1, 2}}) {
      MapChoice choice = maps->choice();
      choice.quantity = quantity;
      choice.x = x, choice.y = y;
      maps->setChoice(choice);
      const QImage image = maps->grab().toImage();
      pictures.insert(
          QByteArray(reinterpret_cast<const char*>(image.constBits()), static_cast<int>(image.sizeInBytes())));
      EXPECT_TRUE(
          QString::fromStdString(maps->asCsv())
              .startsWith(QString::fromStdString(w.session->life().task().state[static_cast<std::size_t>(x)].key)));
    }
  EXPECT_EQ(pictures.size(), 20);
}

TEST(ValueMaps, AProjectionLiesBetweenLeastAndMost) {
  Learned w;
  const Task& task = w.session->life().task();
  MapChoice choice;
  choice.fit(task);
  choice.across[2] = Across::Projected;
  const ValueMap::Quantity rate = [](std::span<const double> s) { return s[2]; };
  const std::vector<double> state(3, 0.0);
  const auto of = [&](Projection projection) {
    choice.projection = projection;
    return choice.projected(task, rate)(state);
  };
  EXPECT_LT(of(Projection::Least), of(Projection::Mean));
  EXPECT_LT(of(Projection::Mean), of(Projection::Most));
  const ValueMap::Quantity never = [](std::span<const double>) { return std::nan(""); };
  EXPECT_TRUE(std::isnan(choice.projected(task, never)(state)));
}

TEST(WorldView, TheBodyIsHeldByTheMouse) {
  Window w;
  auto* world = w.window->findChild<WorldView*>();
  ASSERT_TRUE(w.waitFor([&] { return !w.session->looking().shown().pose.empty(); }));
  QTest::qWait(50);
  QPoint tip;
  for (int y = 10; y < world->height() && tip.isNull(); y += 10) {
    QTest::mouseMove(world, {world->width() / 2, y});
    if (world->cursor().shape() == Qt::OpenHandCursor) tip = {world->width() / 2, y};
  }
  ASSERT_FALSE(tip.isNull());
  QTest::mousePress(world, Qt::LeftButton, {}, tip);
  ASSERT_TRUE(world->held());
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] {  // the next change is a push
    return w.session->life().values() && !w.session->life().values()->changes.empty();
  }));
  EXPECT_EQ(w.session->life().values()->changes.back().key, "push");
  QTest::mouseRelease(world, Qt::LeftButton, {}, tip);
  EXPECT_FALSE(world->held());
}

TEST(LearningCharts, DrawTheCurveInThePolicysColour) {
  Learned w;
  for (auto* chart : w.window->findChildren<LearningChart*>())
    EXPECT_GT(pixelsOf(chart->grab().toImage(), lightTheme().trl), 50);
}

TEST(LearningCharts, SayInAWordWhyTheyAreEmpty) {
  Window w;
  for (auto* chart : w.window->findChildren<LearningChart*>()) {
    const QImage image = chart->grab().toImage();
    int quiet = 0;  // text in the middle
    for (int y = image.height() / 2 - 20; y < image.height() / 2 + 20; ++y)
      for (int x = 100; x < 300; ++x) quiet += qGray(image.pixel(x, y)) < 160;
    EXPECT_GT(quiet, 30);
  }
}

}  // namespace surefoot
