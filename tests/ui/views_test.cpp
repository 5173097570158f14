// SPDX-License-Identifier: GPL-3.0-or-later
#include <QImage>

#include "tests/ui/window_setup.h"
#include "ui/action_rows.h"
#include "ui/learning_charts.h"
#include "ui/theme.h"
#include "ui/value_maps.h"
#include "ui/world_view.h"

namespace surefoot {

namespace {

int pixelsOf(const QImage& image, const QColor& colour) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == colour;
  return count;
}

/// A window whose learner has run for a while and is paused.
struct Learned : Window {
  Learned() : Window("trl") {
    session->setTurbo(true);
    session->setRunning(true);
    EXPECT_TRUE(waitFor([&] { return session->snapshot().totals.episodes > 300 && session->values(); }));
    session->setRunning(false);
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
  w.session->setRunning(true);
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
  const double threshold = w.session->configuration().parameters.get("policy.threshold");
  EXPECT_GT(threshold, 80);
  EXPECT_LT(threshold, 200);
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
