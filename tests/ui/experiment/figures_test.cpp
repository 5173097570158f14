// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of the laboratory: bars and curves of many conditions are all reached, read and told apart.
#include <QTest>
#include <QWheelEvent>
#include <set>

#include "tests/ui/pixels_of.h"
#include "tests/ui/window_setup.h"
#include "ui/controls/table_parts.h"
#include "ui/experiment/figures/figure_painter.h"
#include "ui/experiment/figures/figure_view.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

/// Five groups of a reference and five thresholds, and a base.
Figure manyConditions(bool bars) {
  Figure figure{
      .name = "many", .title = "Many", .xTitle = "time", .yTitle = "falls", .bars = bars, .labels = {}, .series = {}};
  const auto add = [&](const std::string& name, const std::string& policy, const std::string& reference, double value) {
    FigureSeries s{.name = name, .policy = policy, .x = {0}, .y = {{value, value - 2, value + 2}}, .marked = {false}};
    if (!bars) s.x = {0, 1, 2}, s.y = {{0, 0, 1}, {value / 2, value / 2, value / 2}, {value, value - 2, value + 2}};
    s.agent = "sarsa", s.reference = reference, s.lives = s.planned = 40;
    figure.series.push_back(s);
  };
  add("base: ε-greedy", "epsilon-greedy", "", 40);
  for (int group = 1; group <= 5; ++group) {
    const std::string before = "pre(" + std::to_string(group) + "): ";
    add(before + "ε-greedy", "epsilon-greedy", "", 30 + group);
    for (const int threshold : {-50, 0, 50, 100, 150})
      add(before + "TRL " + std::to_string(threshold), "trl", before + "ε-greedy", 20 + group + threshold * 0.01);
  }
  return figure;
}

QImage drawn(const FigurePainter& painter, QSize size) {
  QImage image(size, QImage::Format_RGB32);
  QPainter p(&image);
  painter.paint(p, lightTheme(), size);
  return image;
}

}  // namespace

TEST(Figures, EveryBarOfManyCanBeReachedAndIsWholeInAFile) {
  FigurePainter painter(manyConditions(true));
  const QSizeF whole = painter.fullSize(), small(480, 380);
  EXPECT_EQ(painter.mostScroll(whole), 0) << "a file needs no scroll bar";
  const double most = painter.mostScroll(small);
  EXPECT_GT(most, 0);
  const auto reached = [&](QSizeF size, double scroll) {
    std::set<std::size_t> hit;
    for (double x = 0; x < size.width(); x += 4)
      if (const auto i = painter.seriesAt({x, 200}, size, scroll)) hit.insert(*i);
    return hit;
  };
  EXPECT_EQ(reached(whole, 0).size(), 31u);
  std::set<std::size_t> all;
  for (double scroll = 0; scroll <= most; scroll += 40) all.merge(reached(small, scroll));
  all.merge(reached(small, most));
  EXPECT_EQ(all.size(), 31u);
}

TEST(Figures, TheAxisEndsAtTheTickAboveTheHighestAndHasNoFewerThanNoFalls) {
  Figure figure = manyConditions(true);
  figure.series.resize(2);
  figure.series[0].y = {{100, -20, 200}};
  figure.series[1].y = {{50, 40, 60}};
  EXPECT_EQ(FigurePainter(figure).yRange(), std::pair(0.0, 200.0));
  figure.series[1].y = {{-50, -60, -40}};  // a change in per cent
  EXPECT_EQ(FigurePainter(figure).yRange().first, -100.0);
}

TEST(Figures, AShadeOfAPolicyIsNoOtherPolicys) {
  FigurePainter painter(manyConditions(true));
  painter.setChosen("pre(2): TRL 0");
  const QImage image = drawn(painter, painter.fullSize().toSize());
  int dark = 0;  // a green that is nearly the grey of ε-greedy; where whiskers meet bars there is some
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor c = image.pixelColor(x, y);
      dark += c.green() > c.red() + 30 && c.green() < 120;
    }
  const int green = pixelsOf(image, lightTheme().trl);
  EXPECT_GT(green, 10'000);
  EXPECT_LT(dark, 0.02 * green);
}

TEST(Figures, ABarIsOpenWhileLivesAreMissing) {
  Figure figure = manyConditions(true);
  figure.series.resize(2);
  const int full = pixelsOf(drawn(FigurePainter(figure), {760, 440}), lightTheme().epsilonGreedy);
  figure.series[0].lives = 28;
  const int open = pixelsOf(drawn(FigurePainter(figure), {760, 440}), lightTheme().epsilonGreedy);
  EXPECT_LT(open, 0.7 * full);
}

TEST(Figures, TheListOfCurvesEndsWithHowManyMoreThereAre) {
  FigurePainter painter(manyConditions(false));
  painter.setChosen("pre(3): TRL 150");
  const auto listed = [&](QSizeF size) {
    std::set<std::size_t> hit;
    for (double y = 0; y < size.height(); y += 2)
      if (const auto i = painter.seriesAt({size.width() - 20, y}, size)) hit.insert(*i);
    return hit;
  };
  EXPECT_EQ(listed(painter.fullSize()).size(), 31u);
  const auto few = listed({700, 200});
  EXPECT_LT(few.size(), 15u);
  EXPECT_GE(few.size(), 5u);
  std::size_t chosen = 0;
  while (painter.figure().series[chosen].name != "pre(3): TRL 150") ++chosen;
  EXPECT_TRUE(few.contains(chosen));
}

TEST(Figures, PartOfTheTimeAxisIsShownAndRead) {
  FigureView view(manyConditions(false));
  view.resize(700, 400);
  view.show();
  const QPoint middle(300, 200);
  const auto turn = [&](int by) {
    QWheelEvent event(middle, view.mapToGlobal(middle), {}, {0, by}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
  };
  const QImage whole = view.grab().toImage();
  for (int i = 0; i < 5; ++i) turn(120);
  EXPECT_NE(view.grab().toImage(), whole) << "it is magnified";
  QTest::keyClick(&view, Qt::Key_Home);
  EXPECT_EQ(view.grab().toImage(), whole);
  QTest::mousePress(&view, Qt::LeftButton, {}, {200, 200});
  QTest::mouseMove(&view, {320, 200});
  QTest::mouseRelease(&view, Qt::LeftButton, {}, {320, 200});
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(&view, &leave);
  EXPECT_NE(view.grab().toImage(), whole);
  QTest::mouseDClick(&view, Qt::LeftButton, {}, {320, 200});
  EXPECT_EQ(view.grab().toImage(), whole);
  QTest::keyClick(&view, Qt::Key_Right);
  EXPECT_NE(view.grab().toImage(), whole) << "a line and the values at it";
  QTest::keyClick(&view, Qt::Key_Escape);
  EXPECT_EQ(view.grab().toImage(), whole);
}

TEST(Figures, ThePartThatIsShownStaysWithinTheWhole) {
  FigurePainter painter(manyConditions(false));
  painter.setTime(std::pair(-5.0, 1.0));
  EXPECT_EQ(painter.time(), std::pair(0.0, 2.0)) << "no longer than what there is";
  painter.setTime(std::pair(1.5, 2.5));
  EXPECT_EQ(painter.time(), std::pair(1.0, 2.0));
  EXPECT_TRUE(painter.isPart());
  const QSizeF size(700, 400);
  const QPointF at(300, 200);
  const double time = painter.timeAt(at, size).value();
  EXPECT_TRUE(time > 1 && time < 2);
  EXPECT_EQ(painter.timeAt({690, 200}, size), std::nullopt) << "the list";
  painter.setTime(std::nullopt);
  EXPECT_FALSE(painter.isPart());
}

TEST(Figures, NamesHaveATrueMinusAndGroups) {
  EXPECT_EQ(shownName("pre(2): TRL -50"), QString("pre(2): TRL −50"));
  EXPECT_EQ(shownName("fall -100: tile-coder 4.4-4.9"), QString("fall −100: tile-coder 4.4-4.9"));
  EXPECT_EQ(groupTitle("pre(2, 198)"), "pre-learned on scenario 2 to 198");
  const NameGroups groups = groupNames({"base: a", "pre(1): a", "pre(2): a", "pre(1): TRL -50", "pre(1): TRL 0"});
  EXPECT_EQ(groups.order, (std::vector<std::size_t>{0, 1, 3, 4, 2}));
  EXPECT_EQ(groups.labels[2], QString("−50"));
  ASSERT_EQ(groups.families.size(), 1u);
  EXPECT_EQ(groups.families[0].title, "TRL");
}

TEST(Figures, ProbabilitiesAreWrittenAsInPrint) {
  EXPECT_EQ(pText(1.1e-6), QString("1.1 · 10⁻⁶"));
  EXPECT_EQ(pText(9.99e-5), QString("1.0 · 10⁻⁴"));
  EXPECT_EQ(pText(0.036), ".036");
  EXPECT_EQ(pText(0.8), ".80");
  EXPECT_EQ(pText(0.999), "1.0");
  EXPECT_EQ(pText(std::nan("")), QString("–"));
}

/// A curve of 100 episodes, of which the first ones have other values.
Figure curveThatBegins(std::initializer_list<double> beginning) {
  Figure figure{.name = "a", .title = "a", .xTitle = "episodes", .yTitle = "reward", .labels = {}, .series = {}};
  FigureSeries s{.name = "one", .policy = "trl", .x = {}, .y = {}, .marked = {}};
  std::vector<double> values(beginning);
  for (int k = static_cast<int>(values.size()) + 1; k <= 100; ++k) values.push_back(-100.0 - k);
  for (std::size_t k = 0; k < values.size(); ++k)
    s.x.push_back(static_cast<double>(k + 1)), s.y.push_back({values[k], values[k], values[k]});
  figure.series = {s};
  return figure;
}

// The first episodes of a walk along a cliff are a hundred times as bad as all others.
TEST(FigurePainter, ABadBeginningLeavesTheAxisWithAMark) {
  const auto [low, high] = FigurePainter(curveThatBegins({-10'000, -9'000})).yRange();
  EXPECT_LE(low, -200);
  EXPECT_GE(low, -1000);
  EXPECT_EQ(FigurePainter(curveThatBegins({-300, -200})).yRange().first, -300) << "as far as that, all is shown";
  const auto below = [](const Figure& figure) {  // the mark stands below the axis
    const QImage image = drawn(FigurePainter(figure), {760, 440});
    int row = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < 300; ++x)
        if (image.pixelColor(x, y) == lightTheme().trl) row = y;
    return row;
  };
  EXPECT_GT(below(curveThatBegins({-10'000, -9'000})), below(curveThatBegins({-300, -200})) + 2);
}

}  // namespace surefoot
