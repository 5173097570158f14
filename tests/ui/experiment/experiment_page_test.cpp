// SPDX-License-Identifier: GPL-3.0-or-later
#include <QClipboard>
#include <QGuiApplication>
#include <QTableWidget>

#include "tests/ui/experiment/experiment_window.h"
#include "ui/experiment/figure_panel.h"

namespace surefoot {

TEST(ExperimentPage, RunsAPlanAndShowsWhatCameOfIt) {
  ExperimentWindow p;
  ASSERT_TRUE(p.experiment().plan());
  EXPECT_EQ(p.experiment().livesPlanned(), 12);
  p.runToTheEnd();
  EXPECT_EQ(p.experiment().livesDone(), 12);
  EXPECT_DOUBLE_EQ(p.experiment().share(), 1.0);
  auto* table = p.named<QTableWidget>("Results");
  ASSERT_EQ(table->rowCount(), 2);
  EXPECT_EQ(table->item(1, 0)->text(), "two");
  EXPECT_EQ(table->item(1, 1)->text(), "6");
  for (const FigurePanel* figure : p.page.figures())
    EXPECT_NE(figure->asCsv().find("two"), std::string::npos) << figure->asCsv();
}

TEST(ExperimentPage, ATableWithoutRowsSaysWhy) {
  ExperimentWindow p;
  auto* table = p.named<QTableWidget>("Results");
  ASSERT_EQ(table->rowCount(), 0);
  EXPECT_EQ(p.experiment().whyNoResults(), "Appears when the plan runs.");
  const QImage empty = table->viewport()->grab().toImage();
  QImage paper = empty;
  paper.fill(empty.pixelColor(0, 0));
  EXPECT_NE(empty, paper) << "nothing is written there";
}

TEST(ExperimentPage, PausesAndGoesOnToTheSameEnd) {
  std::string plan = kPlan;
  plan.replace(plan.find("lives = 6"), 9, "lives = 20");
  ExperimentWindow p(plan);
  p.page.runOrPause();
  ASSERT_TRUE(p.waitFor([&] { return p.experiment().livesDone() > 2; }, 30'000));
  p.page.runOrPause();
  ASSERT_TRUE(p.waitFor([&] { return p.experiment().state() == State::Paused; }, 5'000));
  const int done = p.experiment().livesDone();
  EXPECT_LT(done, 40);
  p.runToTheEnd();
  EXPECT_EQ(p.experiment().livesDone(), 40);
  std::int64_t falls = 0;
  for (const Evidence& e : p.experiment().view()->evidence)
    for (const StoredLife& life : e.record.lives) falls += life.falls;
  EXPECT_EQ(p.experiment().falls(), falls) << "those before the pause count, too";
}

TEST(ExperimentPage, PausedItStandsStillAndForgetsNothing) {
  ExperimentWindow p(kLongPlan);
  p.page.runOrPause();
  ASSERT_TRUE(p.waitFor([&] { return p.experiment().falls() > 50; }, 30'000));
  p.page.runOrPause();
  EXPECT_EQ(p.experiment().state(), State::Paused);
  p.waitFor([] { return false; }, 500);  // until the threads have seen it
  const std::int64_t falls = p.experiment().falls();
  p.waitFor([] { return false; }, 500);
  EXPECT_EQ(p.experiment().falls(), falls);
  EXPECT_GE(falls, 50) << "of lives in hand; none is over";
  p.page.runOrPause();
  EXPECT_TRUE(p.waitFor([&] { return p.experiment().falls() > falls; }, 30'000));
}

TEST(ExperimentPage, AWrongPlanIsRefusedInASentence) {
  ExperimentWindow p;
  QString said;
  QObject::connect(&p.page, &ExperimentPage::refused, [&](const QString& s) { said = s; });
  const QString wrong = p.folder.filePath("wrong.toml");
  ASSERT_TRUE(writeWhole("plan", wrong.toStdString(), "lives = 0\n" + kPlan.substr(kPlan.find("reference"))));
  p.page.open(wrong);
  EXPECT_TRUE(said.contains("wrong.toml, line 1")) << said.toStdString();
  EXPECT_EQ(p.experiment().title(), "Two walks") << "the plan before stays";
  p.page.open(p.folder.filePath("nowhere.toml"));
  EXPECT_TRUE(said.contains("nowhere.toml")) << said.toStdString();
}

// Pause is meant for what runs, whatever is being read meanwhile.
TEST(ExperimentPage, PauseWhileAnotherPlanIsReadPauses) {
  ExperimentWindow p(kLongPlan);
  p.page.runOrPause();
  ASSERT_TRUE(p.waitFor([&] { return p.experiment().falls() > 0; }, 30'000));
  std::string large = "title = \"Large\"\nlives = 2\n[base]\nminutes = 1\n";
  for (int i = 0; i < 2000; ++i)
    large += "[[condition]]\nname = \"c" + std::to_string(i) + "\"\nset.policy.epsilon = 0.0" +
             std::to_string(1000 + i) + "\n";
  const QString other = p.folder.filePath("large.toml");
  ASSERT_TRUE(writeWhole("plan", other.toStdString(), large));
  p.page.open(other);
  if (!p.experiment().isOpening()) GTEST_SKIP() << "this machine reads it faster than one could press Pause";
  p.page.runOrPause();
  EXPECT_EQ(p.experiment().state(), State::Paused);
  ASSERT_TRUE(p.waitFor([&] { return !p.experiment().isOpening(); }, 60'000));
  EXPECT_EQ(p.experiment().state(), State::Ready) << "nobody asked for it to run";
}

TEST(ExperimentPage, TheTableIsCopied) {
  ExperimentWindow p;
  QString said;
  QObject::connect(&p.page, &ExperimentPage::refused, [&](const QString& s) { said = s; });
  p.page.copyCsv();
  EXPECT_TRUE(said.contains("nothing to copy")) << said.toStdString();
  p.runToTheEnd();
  p.page.copyCsv();
  EXPECT_TRUE(QGuiApplication::clipboard()->text().startsWith("condition,reference,lives"));
  p.page.copyLatex();
  EXPECT_TRUE(QGuiApplication::clipboard()->text().startsWith("\\begin{tabular}"));
}

}  // namespace surefoot
