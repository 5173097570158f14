// SPDX-License-Identifier: GPL-3.0-or-later
// What the Experiment page offers with many conditions: recipes are found, files get their endings, the plan is kept,
// and the window never waits for it.
#include <time.h>

#include <QElapsedTimer>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeWidget>
#include <cstdio>

#include "core/files/whole_file.h"
#include "tests/ui/window_setup.h"
#include "ui/experiment/experiment_page.h"
#include "ui/experiment/plan_editor.h"
#include "ui/experiment/plans/plan_chooser.h"
#include "ui/support/ask_for_file.h"

namespace surefoot {

namespace {

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

TEST(PlanChooser, FindsARecipeByTheNumberOfAnyOfItsFigures) {
  PlanChooser box("Experiment",
                  {{.title = "Quick", .path = "q.toml"},
                   {.title = "After pre-learning",
                    .path = "a.toml",
                    .recipe = true,
                    .group = "Chapter 4",
                    .shows = {"4.4", "4.5", "4.6", "table 4.2"},
                    .answers = "Which one?",
                    .minutes = 4},
                   {.title = "Scenario 6", .path = "b.toml", .recipe = true, .group = "Chapter 4", .shows = {"4.12"}}});
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
  ASSERT_TRUE(w.waitFor([&] { return !w.window->experimentPage().experiment().isOpening(); }));
  const std::string plan = "lives = 2\n[[condition]]\nname = \"a\"\nminutes = 1\n";
  edit->setPlainText(QString::fromStdString(plan));
  edit->moveCursor(QTextCursor::End);
  QTest::keyClicks(edit, "# mine");
  Q_EMIT editor->liveConditionAsked();
  ASSERT_TRUE(w.waitFor([&] { return edit->toPlainText().contains("live: trl"); }));
  const auto refused = [&] {
    const auto labels = editor->findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [](auto* l) { return l->text().startsWith("It is not added"); });
  };
  Q_EMIT editor->liveConditionAsked();
  EXPECT_TRUE(w.waitFor(refused));
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
  std::string plan =
      "title = \"Many\"\nlives = 6\nreference = \"α 0\"\n[base]\nenvironment = \"cliff\"\nfeatures = "
      "\"table\"\nepisodes = 400\n";
  for (int i = 0; i < 31; ++i)
    plan += "[[condition]]\nname = \"α " + std::to_string(i) +
            "\"\nset.agent.step_size = " + std::to_string(0.1 + 0.02 * i) + "\n";
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
