// SPDX-License-Identifier: GPL-3.0-or-later
// The charts of the Live page: spans of time, marks that answer, the cursor, earlier runs.
#include "ui/live/charts/learning_charts.h"

#include <QApplication>
#include <QUndoStack>
#include <QWheelEvent>

#include "tests/ui/window_setup.h"
#include "ui/controls/panel.h"
#include "ui/live/live_page.h"

namespace surefoot {

namespace {

/// A window whose life has learned for so many episodes and stands.
struct Lived : Window {
  explicit Lived(std::int64_t episodes, const std::string& policy = "epsilon-greedy") : Window(policy, episodes) {
    live();
  }
  void live() {
    session->life().setTurbo(true);
    session->life().setRunning(true);
    EXPECT_TRUE(waitFor([&] { return session->life().finished(); }, 60'000));
    const std::int64_t episodes = *configuration.episodes;
    EXPECT_TRUE(waitFor([&] { return session->life().numbers().episodes == episodes; }));
    QTest::qWait(50);
  }
  LearningChart& chart(const char* name) {
    for (auto* c : window->findChildren<LearningChart*>())
      if (c->accessibleName() == name) return *c;
    ADD_FAILURE() << name;
    std::abort();
  }
  LearningChart& falls() { return chart("Falls"); }
  LearningChart& reward() { return chart("Average reward"); }
  ChartSpan& span() { return *window->findChild<ChartSpan*>(); }
};

QPoint pointOf(const LearningChart& chart, double x, double fromBottom) {
  return {static_cast<int>(std::lround(x - 0.5)), static_cast<int>(chart.plot().bottom() - fromBottom)};
}

void turnWheel(LearningChart& chart, QPointF at, int delta) {
  QWheelEvent event(at, chart.viewport()->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(chart.viewport(), &event);
}

}  // namespace

TEST(LearningCharts, EveryMarkOfAFallAnswersAClick) {
  Lived w(6000);
  ASSERT_EQ(w.span().shows(), ChartSpan::Shows::Learning) << "the life is much longer than learning was";
  for (const bool whole : {false, true}) {
    whole ? w.span().showWholeLife() : w.span().showLearning();
    const auto marks = w.falls().fallMarks();
    ASSERT_GT(marks.size(), 20u);
    for (const auto& mark : marks) {
      ASSERT_TRUE(mark.answers);
      QTest::mouseClick(w.falls().viewport(), Qt::LeftButton, {}, pointOf(w.falls(), mark.x, 4));
      ASSERT_TRUE(w.session->looking().playback()) << "the mark at " << mark.x;
      w.session->looking().backToLive();
      QTest::qWait(1);
    }
  }
}

TEST(LearningCharts, NumbersBelongToTheSpanThatIsShown) {
  Lived w(6000);
  w.span().showLearning();
  const double end = w.span().to();
  std::int64_t falls = 0;
  for (const CurvePoint& p : w.session->life().curves().live().points)
    if (w.span().timeOf(p) <= end) falls = p.falls;
  ASSERT_LT(falls, w.session->life().numbers().falls);
  ASSERT_EQ(w.falls().items().size(), 1u);
  EXPECT_EQ(w.falls().items()[0].text.remove(','), QString::number(falls));
  w.span().showWholeLife();
  EXPECT_EQ(w.falls().items()[0].text.remove(','), QString::number(w.session->life().numbers().falls));
}

TEST(LearningCharts, APolicysColourBeginsWhereItsSwitchWas) {
  RunCurves curves;
  std::vector<CurvePoint> points;
  for (int i = 1; i <= 10; ++i) points.push_back({i, 100 * i, i, 10.0 * i});
  curves.update("sarsa", "trl", points, {{.step = 450, .key = "policy", .before = "softmax", .after = "trl"}});
  const auto& pieces = curves.live().pieces;
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].policy, "softmax");
  EXPECT_EQ(pieces[0].points.back().lifeSteps, 450);
  EXPECT_EQ(pieces[1].points.front().lifeSteps, 450);
  EXPECT_DOUBLE_EQ(pieces[1].points.front().averageReward, 45.0);
}

TEST(LearningCharts, WheelDragAndKeysMagnifyTheTimeAxisAndHomeShowsAll) {
  Lived w(1500);
  w.span().showWholeLife();
  LearningChart& chart = w.falls();
  const double all = w.span().to();
  const QPointF at = chart.plot().center();
  const double before = w.span().from() + (w.span().to() - w.span().from()) / 2;
  turnWheel(chart, at, 360);
  ASSERT_EQ(w.span().shows(), ChartSpan::Shows::Part);
  EXPECT_LT(w.span().to() - w.span().from(), 0.7 * all);
  EXPECT_NEAR((w.span().from() + w.span().to()) / 2, before, 1e-6 * all) << "what is under the cursor stays there";
  chart.setFocus(Qt::TabFocusReason);
  QTest::keyClick(&chart, Qt::Key_Home);
  EXPECT_EQ(w.span().shows(), ChartSpan::Shows::WholeLife);
  EXPECT_EQ(w.span().to(), all);

  const double pace = w.session->life().pace();
  QTest::keyClick(&chart, Qt::Key_Plus);
  EXPECT_NEAR(w.span().to() - w.span().from(), 0.7 * all, 1e-9 * all);
  EXPECT_EQ(w.session->life().pace(), pace) << "with the focus in the chart + is the chart's";
  QTest::keyClick(&chart, Qt::Key_Minus);
  EXPECT_EQ(w.span().shows(), ChartSpan::Shows::WholeLife);

  const QPoint left(static_cast<int>(chart.plot().left() + 0.25 * chart.plot().width()), 40);
  const QPoint right(static_cast<int>(chart.plot().left() + 0.5 * chart.plot().width()), 40);
  QTest::mousePress(chart.viewport(), Qt::LeftButton, {}, left);
  QTest::mouseMove(chart.viewport(), {(left.x() + right.x()) / 2, 40});
  QTest::mouseMove(chart.viewport(), right);
  QTest::mouseRelease(chart.viewport(), Qt::LeftButton, {}, right);
  EXPECT_NEAR(w.span().from(), 0.25 * all, 0.01 * all);
  EXPECT_NEAR(w.span().to(), 0.5 * all, 0.01 * all);
  QTest::mouseDClick(chart.viewport(), Qt::LeftButton, {}, left);
  EXPECT_EQ(w.span().shows(), ChartSpan::Shows::WholeLife);
}

TEST(LearningCharts, TheCursorReadsTheCurveUnderIt) {
  Lived w(1500);
  w.span().showWholeLife();
  LearningChart& chart = w.falls();
  const CurvePoint p = w.session->life().curves().live().points[700];  // more points move them
  const double x = w.span().timeOf(p);
  const int pixel = static_cast<int>(chart.plot().left() + x / w.span().to() * chart.plot().width());
  QTest::mouseMove(chart.viewport(), {pixel, 60});
  const QString reading = chart.reading();
  const auto words = reading.split(' ');
  ASSERT_GE(words.size(), 5) << reading.toStdString();
  EXPECT_NEAR(words[0].toDouble(), x, 0.02 * w.span().to());
  EXPECT_NEAR(words[2].toDouble(), static_cast<double>(p.falls), 3);
  EXPECT_TRUE(reading.contains("falls")) << reading.toStdString();
  EXPECT_FALSE(w.reward().reading().isEmpty()) << "the charts share the cursor";
  chart.setFocus();
  const double before = *w.span().cursor();
  QTest::keyClick(&chart, Qt::Key_Right);
  EXPECT_GT(*w.span().cursor(), before);
  EXPECT_EQ(chart.accessibleDescription(), chart.reading()) << "and is spoken";
  QTest::keyClick(&chart, Qt::Key_Escape);
  EXPECT_FALSE(w.span().cursor());
}

TEST(LearningCharts, EarlierRunsAreRemovedAndUndoBringsThemBack) {
  Lived w(60);
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(w.session->newLives().restart());
    w.live();
  }
  const auto numbers = [&] {
    std::vector<int> list;
    for (const RunCurve& c : w.session->life().curves().earlier()) list.push_back(c.number);
    return list;
  };
  ASSERT_EQ(numbers(), (std::vector<int>{1, 2}));
  EXPECT_EQ(w.reward().items().size(), 3u);
  w.session->history().removeEarlierRuns({1});
  EXPECT_EQ(numbers(), (std::vector<int>{2}));
  EXPECT_EQ(w.reward().items().size(), 2u);
  w.session->history().undo().undo();
  EXPECT_EQ(numbers(), (std::vector<int>{1, 2}));
  LearningChart& chart = w.reward();
  chart.setFocus();
  QTest::keyClick(&chart, Qt::Key_Right);  // a cursor
  for (int i = 0; i < 3 && !chart.reading().contains("run 2"); ++i) QTest::keyClick(&chart, Qt::Key_Up);
  ASSERT_TRUE(chart.reading().contains("run 2")) << chart.reading().toStdString();
  QTest::keyClick(&chart, Qt::Key_Delete);
  EXPECT_EQ(numbers(), (std::vector<int>{1}));
}

TEST(LearningCharts, TheAverageHasATimeAxisOfItsOwnWhereFallsDoesNotStandBelow) {
  Lived w(100);
  ASSERT_LT(w.reward().height() - w.reward().plot().bottom(), 20) << "the axis below is for both";
  const auto ownAxis = [&] { return w.reward().height() - w.reward().plot().bottom() > 30; };
  auto* list = w.window->livePage().findChild<Panel*>("list");
  list->show();
  list->raise();  // its tab lies before Falls
  EXPECT_TRUE(w.waitFor(ownAxis));
  auto* falls = w.window->livePage().findChild<Panel*>("falls");
  falls->raise();
  EXPECT_TRUE(w.waitFor([&] { return !ownAxis(); }));
  falls->setFloating(true);
  EXPECT_TRUE(w.waitFor(ownAxis));
}

}  // namespace surefoot
