// SPDX-License-Identifier: GPL-3.0-or-later
// What the Experiment page shows of many conditions: everything can be reached, nothing is cut in a file, shades are no
// other policy's, and the window never waits for it.
#include <time.h>

#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeWidget>
#include <QWheelEvent>
#include <cmath>
#include <cstdio>
#include <set>

#include "core/files/whole_file.h"
#include "tests/ui/window_setup.h"
#include "ui/ask_for_file.h"
#include "ui/experiment_page.h"
#include "ui/figure_painter.h"
#include "ui/figure_view.h"
#include "ui/plan_chooser.h"
#include "ui/plan_editor.h"
#include "ui/table_parts.h"
#include "ui/theme.h"

namespace surefoot {

namespace {

/// Five groups of a reference and five thresholds, and a base.
Figure manyConditions(bool bars) {
  Figure figure{.name = "many", .title = "Many", .xTitle = "time", .yTitle = "falls", .bars = bars, .labels = {}, .series = {}};
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

int pixelsOf(const QImage& image, const QColor& colour) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) == colour.rgb();
  return count;
}

/// The longest time for which the event loop was held up: by work of its own thread, and by anything.
class HaltMeter : public QObject {
 public:
  HaltMeter() {
    clock_.start();
    startTimer(5);
  }
  double work = 0, wall = 0;  // [ms]

 protected:
  void timerEvent(QTimerEvent*) override {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    const double now = static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
    if (before_ > 0) work = std::max(work, now - before_);
    before_ = now;
    wall = std::max(wall, static_cast<double>(clock_.restart()));
  }

 private:
  QElapsedTimer clock_;
  double before_ = 0;
};

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

TEST(PlanChooser, FindsARecipeByTheNumberOfAnyOfItsFigures) {
  PlanChooser box("Experiment", {{.title = "Quick", .path = "q.toml"},
                                 {.title = "After pre-learning", .path = "a.toml", .recipe = true, .group = "Chapter 4",
                                  .shows = {"4.4", "4.5", "4.6", "table 4.2"}, .answers = "Which one?", .minutes = 4},
                                 {.title = "Scenario 6", .path = "b.toml", .recipe = true, .group = "Chapter 4",
                                  .shows = {"4.12"}}});
  box.show();
  QString chosen;
  QObject::connect(&box, &PlanChooser::planChosen, [&](const QString& path) { chosen = path; });
  box.showPopup();
  auto* words = box.findChild<QLineEdit*>();
  auto* list = box.findChild<QTreeWidget*>();
  ASSERT_TRUE(words && list);
  QTest::keyClicks(words, "4.6");
  ASSERT_TRUE(list->currentItem());
  EXPECT_EQ(list->currentItem()->text(1), "After pre-learning");
  EXPECT_EQ(list->currentItem()->text(2), "about 4 min");
  QTest::keyClick(words, Qt::Key_Return);
  EXPECT_EQ(chosen, "a.toml");
  EXPECT_EQ(numbersOf({.title = "", .path = "", .shows = {"4.4", "4.5", "table 4.2"}}), QString("4.4–4.5"));
}

TEST(AskForFile, ANameWithoutAnEndingGetsThatOfTheChosenKind) {
  QTemporaryDir folder;
  QWidget parent;
  QString written;
  askForNewFile(&parent, "Export", folder.filePath("falls.png"), "Picture (*.png);;Vector graphics (*.svg)", "png",
                [&](const QString& path) { written = path; });
  auto* dialog = parent.findChild<QFileDialog*>();
  ASSERT_TRUE(dialog);
  dialog->selectNameFilter("Vector graphics (*.svg)");
  auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
  ASSERT_TRUE(name);
  name->setText(folder.filePath("abc"));
  QMetaObject::invokeMethod(dialog, "accept");
  EXPECT_EQ(written, folder.filePath("abc.svg"));
}

TEST(ExperimentPage, WhatIsAddedToAPlanCanBeUndone) {
  Window w;
  w.window->setPage(1);
  auto* editor = w.window->findChild<PlanEditor*>();
  auto* edit = w.named<QPlainTextEdit>("Plan");
  const std::string plan = "lives = 2\n[[condition]]\nname = \"a\"\nminutes = 1\n";
  edit->setPlainText(QString::fromStdString(plan));
  edit->moveCursor(QTextCursor::End);
  QTest::keyClicks(edit, "# mine");
  Q_EMIT editor->liveConditionAsked();
  ASSERT_TRUE(edit->toPlainText().contains("live: trl"));
  Q_EMIT editor->liveConditionAsked();
  EXPECT_EQ(edit->toPlainText().count("live: trl"), 1) << "the same condition twice would be refused";
  edit->undo();
  EXPECT_FALSE(edit->toPlainText().contains("live: trl"));
  EXPECT_TRUE(edit->toPlainText().contains("# mine"));
  edit->undo();
  EXPECT_FALSE(edit->toPlainText().contains("# mine")) << "what was typed before it can be undone, too";
}

TEST(ExperimentPage, TheNumberOfLivesChangesWithoutThePlansText) {
  EXPECT_EQ(withLives("title = \"a\"\nlives = 40 # many\n[base]\nx = 1\n", 5),
            "title = \"a\"\nlives = 5 # many\n[base]\nx = 1\n");
  EXPECT_EQ(withLives("[[condition]]\nlives = 3\n", 5), "lives = 5\n[[condition]]\nlives = 3\n");
}

TEST(ExperimentPage, ManyConditionsNeverHoldTheWindowUp) {
  Window w;
  w.window->setPage(1);
  ExperimentPage& page = w.window->experimentPage();
  QTemporaryDir folder;
  std::string plan = "title = \"Many\"\nlives = 6\nreference = \"α 0\"\n[base]\nenvironment = \"cliff\"\nfeatures = \"table\"\nepisodes = 400\n";
  for (int i = 0; i < 31; ++i)
    plan += "[[condition]]\nname = \"α " + std::to_string(i) + "\"\nset.agent.step_size = " +
            std::to_string(0.1 + 0.02 * i) + "\n";
  const QString path = folder.filePath("many.toml"), other = folder.filePath("other.toml");
  ASSERT_TRUE(writeWhole("plan", path.toStdString(), plan));
  ASSERT_TRUE(writeWhole("plan", other.toStdString(), "title = \"Other\"\n" + plan.substr(plan.find("lives"))));
  HaltMeter meter;
  page.open(path);
  ASSERT_TRUE(w.waitFor([&] { return !page.experiment().isOpening(); }, 60'000));
  page.runOrPause();
  ASSERT_TRUE(w.waitFor([&] { return page.experiment().state() == Experiment::State::Complete; }, 120'000));
  for (const FigureSpec& spec : page.experiment().figures()) page.experiment().look(0, spec);
  page.startAgain();
  page.runOrPause();
  QTest::qWait(300);
  page.open(other);  // while it runs
  ASSERT_TRUE(w.waitFor([&] { return page.experiment().title() == "Other"; }, 60'000));
  std::printf("longest halt: %.0f ms of work, %.0f ms by the clock\n", meter.work, meter.wall);
  EXPECT_LT(meter.work, 100);
}

}  // namespace surefoot
