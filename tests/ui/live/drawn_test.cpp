// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn is what is: a threshold, a scale, a mark or a word stands only where it holds.
#include <QImage>
#include <algorithm>

#include "core/text/text.h"
#include "tests/ui/window/text_recorder.h"
#include "tests/ui/window_setup.h"
#include "ui/live/actions/action_rows.h"
#include "ui/live/charts/learning_charts.h"
#include "ui/live/form/parameter_form.h"
#include "ui/live/live_page.h"
#include "ui/live/maps/value_maps.h"
#include "ui/live/rival.h"
#include "ui/live/rule_view.h"
#include "ui/live/world/world_view.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

bool says(QWidget& widget, const QString& words) {
  const auto texts = drawnTexts(widget);
  return std::any_of(texts.begin(), texts.end(), [&](const DrawnText& t) { return t.text.contains(words); });
}

/// One text where symbols are drawn in pieces.
QString allOf(QWidget& widget) {
  QString all;
  for (const DrawnText& t : drawnTexts(widget)) all += t.text;
  return all;
}

}  // namespace

TEST(Drawn, AThresholdBeyondTheValuesHasNoLineAndNoContour) {
  Elsewhere w("cliff", "trl");
  auto* rows = w.window->findChild<ActionRows*>();
  auto* maps = w.window->findChild<ValueMaps*>();
  ASSERT_GT(w.session->life().threshold(), rows->scaleOfQ().second) << "no value of the cliff is as high";
  EXPECT_TRUE(says(*rows, "threshold 50 ›"));
  EXPECT_TRUE(says(*maps, "all values below threshold 50"));
  EXPECT_FALSE(says(*maps, "contour"));
  // A life that falls often expects less than −200, so it stands still, and the threshold lies below its lowest value.
  w.session->life().setRunning(false);
  QTest::qWait(300);
  const double below = 10 * rows->scaleOfQ().first;
  ASSERT_TRUE(w.session->editing().setParameter("policy.threshold", below));
  const QString flag = QStringLiteral("threshold %1 ‹").arg(QString::fromStdString(countText(below)));
  EXPECT_TRUE(w.waitFor([&] { return says(*rows, flag); })) << rows->scaleOfQ().first;
}

TEST(Drawn, TheScaleOfQIsThatOfTheValues) {
  Elsewhere w("compass");
  const Task& task = w.session->life().task();
  auto* rows = w.window->findChild<ActionRows*>();
  const auto [low, high] = rows->scaleOfQ();
  EXPECT_LT(high, task.highestReturn) << "four episodes teach nothing of 1,000";
  EXPECT_NEAR(low / high, task.lowestReturn / task.highestReturn, 1e-9);
  ASSERT_TRUE(w.session->newLives().restart());
  EXPECT_TRUE(w.waitFor([&] { return rows->scaleOfQ().second <= high; }));
}

TEST(Drawn, TheRewardsAxisHasANumberAtEachEnd) {
  for (const char* environment : {"compass", "pendulum", "cliff", "mountain-car"}) {
    Elsewhere w(environment);
    for (auto* chart : w.window->findChildren<LearningChart*>()) {
      if (chart->accessibleName() != "Average reward") continue;
      std::vector<double> at;
      for (const DrawnText& t : drawnTexts(*chart->viewport()))
        if (t.place.right() < chart->plot().left()) at.push_back(t.place.center().y());
      ASSERT_GE(at.size(), 2u) << environment;
      const auto [top, bottom] = std::minmax_element(at.begin(), at.end());
      EXPECT_NEAR(*top, chart->plot().top() + 4, 3) << environment;
      EXPECT_NEAR(*bottom, chart->plot().bottom() - 4, 3) << environment;
    }
  }
}

TEST(Drawn, MapsOfWideWorldsTakeTheRoomThereIs) {
  Elsewhere w("cliff");
  auto* maps = w.window->findChild<ValueMaps*>();
  double left = 1e9, right = 0;  // of the numbers below the large map
  for (const DrawnText& t : drawnTexts(*maps))
    if (t.text == "0" || t.text == "10")
      left = std::min(left, t.place.left()), right = std::max(right, t.place.right());
  EXPECT_GT(right - left, maps->width() / 2.0);
}

TEST(Drawn, OfTwoWorldsEachSaysWhichItIs) {
  Window w("trl");
  w.window->livePage().setComparing(true);
  w.session->life().setRunning(true);
  WorldView& first = w.window->livePage().world();
  WorldView& second = w.window->livePage().rival()->world();
  EXPECT_TRUE(w.waitFor([&] { return says(first, "First") && says(second, "Second"); }));
  EXPECT_TRUE(says(first, "TRL, Sarsa"));
  EXPECT_TRUE(says(second, "Softmax, Sarsa"));
}

TEST(Drawn, TheRuleOfThumbIsSetAsAFormula) {
  Elsewhere w("pendulum", "trl");
  w.session->life().setRunning(true);
  auto* page = &w.window->livePage();
  page->useLayout(LivePage::Layout::Teaching);
  auto* rule = w.window->findChild<RuleView*>();
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().values() && w.session->life().values()->rule; }, 30'000));
  ASSERT_TRUE(w.waitFor([&] { return allOf(*rule).contains("γ"); }));
  EXPECT_FALSE(allOf(*rule).contains("^")) << allOf(*rule).toStdString();
  EXPECT_FALSE(allOf(*rule).contains("_"));
}

}  // namespace surefoot
