// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/experiment_page.h"

#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>

#include "core/files/whole_file.h"
#include "tests/ui/window_setup.h"
#include "ui/experiment/figure_panel.h"
#include "ui/experiment/plan_editor.h"
#include "ui/experiment/plans/condition_form.h"

namespace surefoot {

namespace {

using State = Experiment::State;

const std::string kPlan =
    "title = \"Two walks\"\nlives = 6\nreference = \"one\"\n[base]\nenvironment = \"cliff\"\nfeatures = \"table\"\n"
    "episodes = 200\n[[condition]]\nname = \"one\"\n[[condition]]\nname = \"two\"\npolicy = \"softmax\"\n";

const std::string kLongPlan =
    "lives = 1\nreference = \"one\"\n[base]\nminutes = 150\n[[condition]]\nname = \"one\"\n[[condition]]\n"
    "name = \"two\"\npolicy = \"softmax\"\n";

/// A window at its Experiment page, with a plan in a folder of its own.
struct Page : Window {
  explicit Page(const std::string& plan = kPlan) : page(window->experimentPage()) {
    path = folder.filePath("plan.toml");
    EXPECT_TRUE(writeWhole("plan", path.toStdString(), plan));
    window->setPage(1);
    page.open(path);
    EXPECT_TRUE(waitFor([&] { return !page.experiment().isOpening(); }));
    QObject::connect(&page, &ExperimentPage::refused, [this](const QString& why) { refusal = why.toStdString(); });
  }
  void runToTheEnd() {
    page.runOrPause();
    EXPECT_TRUE(waitFor([&] { return experiment().state() == State::Complete; }, 60'000)) << refusal;
  }
  Experiment& experiment() { return page.experiment(); }

  QTemporaryDir folder;
  QString path;
  std::string refusal;
  ExperimentPage& page;
};

}  // namespace

TEST(ExperimentPage, RunsAPlanAndShowsWhatCameOfIt) {
  Page p;
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
  Page p;
  auto* table = p.named<QTableWidget>("Results");
  ASSERT_EQ(table->rowCount(), 0);
  EXPECT_EQ(p.experiment().whyNoResults(), "Appears when the plan runs.");
  const QImage empty = table->viewport()->grab().toImage();
  QImage paper = empty;
  paper.fill(empty.pixelColor(0, 0));
  EXPECT_NE(empty, paper) << "nothing is written there";
}

TEST(ExperimentPage, TheResultsAreThoseOfAHeadlessRun) {
  Page p;
  p.runToTheEnd();
  const auto plan = parsePlan(p.registry, kPlan, "plan.toml", {});
  const std::string other = p.folder.filePath("headless.sqlite").toStdString();
  auto store = Store::create(other, *planToStore(p.registry, *plan));
  ASSERT_TRUE(runPlan(p.registry, *plan, *store, {}));
  const auto shown = Store::open(p.experiment().storePath());
  ASSERT_TRUE(shown) << shown.error().message;
  EXPECT_EQ(*shown->contentHash(), *store->contentHash());
}

TEST(ExperimentPage, PausesAndGoesOnToTheSameEnd) {
  std::string plan = kPlan;
  plan.replace(plan.find("lives = 6"), 9, "lives = 20");
  plan.replace(plan.find("episodes = 200"), 14, "episodes = 400");
  Page p(plan);
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

TEST(ExperimentPage, OpensResultsMadeWithoutAWindow) {
  Page p;
  p.runToTheEnd();
  const QString results = p.folder.filePath("results.sqlite");
  ASSERT_TRUE(QFile::copy(QString::fromStdString(p.experiment().storePath()), results));
  QString said;
  QObject::connect(&p.page, &ExperimentPage::refused, [&](const QString& s) { said = s; });
  const QString store = QString::fromStdString(p.experiment().storePath());
  p.page.startAgain();
  EXPECT_FALSE(p.experiment().view());
  EXPECT_TRUE(said.contains(store)) << "nobody is left without knowing where his lives are: " << said.toStdString();
  p.page.open(results);
  ASSERT_TRUE(p.experiment().view());
  EXPECT_EQ(p.experiment().state(), State::Complete);
  EXPECT_EQ(p.experiment().title(), "Two walks");
  EXPECT_FALSE(p.experiment().canRun()) << "nothing is missing";
}

TEST(ExperimentPage, PausedItStandsStillAndForgetsNothing) {
  Page p(kLongPlan);
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

TEST(ExperimentPage, AStoreThatIsOpenedAgainGoesOnToTheSameContent) {
  const auto plan = parsePlan(fullRegistry(), kLongPlan, "plan.toml", {});
  QTemporaryDir folder;
  const QString kept = folder.filePath("kept.sqlite");
  {
    Page p(kLongPlan);
    p.page.runOrPause();
    ASSERT_TRUE(p.waitFor([&] { return p.experiment().falls() > 50; }, 30'000));
    const QString store = QString::fromStdString(p.experiment().storePath());
    p.page.startAgain();  // which keeps what was in hand
    ASSERT_TRUE(p.waitFor([&] { return QFile::exists(store + ".lives") && !QFile::exists(store + "-lock"); }, 30'000));
    ASSERT_TRUE(QFile::copy(store, kept));
    ASSERT_TRUE(QDir().rename(store + ".lives", kept + ".lives"));
  }
  Page p;
  p.page.open(kept);
  ASSERT_TRUE(p.waitFor([&] { return !p.experiment().isOpening(); }));
  EXPECT_EQ(p.experiment().state(), State::Paused);
  ASSERT_TRUE(p.experiment().canRun());
  EXPECT_TRUE(p.experiment().text().empty());
  p.runToTheEnd();
  EXPECT_FALSE(QFile::exists(kept + ".lives"));
  const std::string other = folder.filePath("headless.sqlite").toStdString();
  auto headless = Store::create(other, *planToStore(p.registry, *plan));
  ASSERT_TRUE(runPlan(p.registry, *plan, *headless, {.jobs = 2}));
  EXPECT_EQ(*Store::open(kept.toStdString())->contentHash(), *headless->contentHash());
}

TEST(ExperimentPage, AStoreOfAnotherVersionGoesOnOnlyIfThatIsWanted) {
  Page p;
  const std::string path = p.folder.filePath("other.sqlite").toStdString();
  const auto plan = parsePlan(p.registry, kPlan, "plan.toml", {});
  {
    auto store = Store::create(path, *planToStore(p.registry, *plan));
    ASSERT_TRUE(store->save({.life = 0, .episodes = 0, .diverged = {}, .livesVersion = 77, .program = "9.9"}, {}, {}));
  }
  p.page.open(QString::fromStdString(path));
  ASSERT_TRUE(p.waitFor([&] { return !p.experiment().isOpening(); }));
  const Status refused = p.experiment().run();
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("9.9"), std::string::npos) << refused.error().message;
  EXPECT_TRUE(p.experiment().needsConsent());
  EXPECT_TRUE(p.experiment().run(true));
  EXPECT_TRUE(p.waitFor([&] { return p.experiment().state() == State::Complete; }, 60'000));
}

TEST(ExperimentPage, AWrongPlanIsRefusedInASentence) {
  Page p;
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

TEST(ExperimentPage, EditsThatAreNotUsedYetAreNotLost) {
  Page p(kPlan);
  auto* editor = p.page.findChild<PlanEditor*>();
  auto* edit = editor->findChild<QPlainTextEdit*>();
  p.page.showPlan(true);
  const QString before = editor->text();
  edit->appendPlainText("# mine");
  p.page.startAgain();
  EXPECT_TRUE(editor->text().contains("# mine"));
  auto* lives = p.named<QSpinBox>("Lives a condition");
  ASSERT_TRUE(lives);
  lives->setValue(5);
  Q_EMIT lives->editingFinished();
  EXPECT_TRUE(editor->text().contains("# mine"));
  EXPECT_TRUE(editor->text().contains("lives = 5")) << editor->text().toStdString();
  const QString other = p.folder.filePath("other.toml");
  ASSERT_TRUE(writeWhole("plan", other.toStdString(), "title = \"Other\"\n" + kPlan.substr(kPlan.find("lives"))));
  p.page.open(other);
  ASSERT_TRUE(p.waitFor([&] { return !p.experiment().isOpening(); }));
  EXPECT_FALSE(editor->text().contains("# mine"));
  edit->undo();
  EXPECT_TRUE(editor->text().contains("# mine")) << "undo brings them back";
}

// Pause is meant for what runs, whatever is being read meanwhile.
TEST(ExperimentPage, PauseWhileAnotherPlanIsReadPauses) {
  Page p(kLongPlan);
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

TEST(ExperimentPage, ThePlanIsEditedAsTextAndChecked) {
  Page p;
  p.page.showPlan(true);
  auto* edit = p.named<QPlainTextEdit>("Plan");
  auto* editor = p.window->findChild<PlanEditor*>();
  EXPECT_TRUE(edit->toPlainText().contains("Two walks"));
  editor->setText(edit->toPlainText() + "[[condition]]\nname = \"three\"\npolicy = \"nobody\"\n");
  QPushButton* use = nullptr;
  for (auto* button : editor->findChildren<QPushButton*>())
    if (button->text() == "Use this plan") use = button;
  ASSERT_TRUE(use);
  EXPECT_FALSE(use->isEnabled()) << "there is no such policy";
  editor->setText(QString::fromStdString(kPlan));
  Q_EMIT editor->liveConditionAsked();
  EXPECT_TRUE(edit->toPlainText().contains("live: trl"));
  ASSERT_TRUE(use->isEnabled());
  QTest::mouseClick(use, Qt::LeftButton);
  EXPECT_EQ(p.experiment().storedPlan().conditions.size(), 3u);
}

TEST(ExperimentPage, AFormWritesConditionsIntoThePlan) {
  Page p;
  p.page.showPlan(true);
  auto* editor = p.window->findChild<PlanEditor*>();
  auto* form = p.window->findChild<ConditionForm*>();
  const auto choose = [&](const char* name, const char* value) {
    auto* combo = p.named<QComboBox>(name);
    combo->setCurrentIndex(combo->findData(value));
    Q_EMIT combo->activated(combo->currentIndex());
  };
  choose("Environment of the condition", "pendulum");
  choose("Policy of the condition", "trl");
  choose("Scenario of the condition", "3");
  choose("Parameter 1 to set", "policy.threshold");
  p.named<QLineEdit>("Values of parameter 1")->setText("0, 50 ,much");
  EXPECT_NE(form->toml().error().message.find("much"), std::string::npos);
  p.named<QLineEdit>("Values of parameter 1")->setText("0, 50");
  choose("Pre-learning of the condition", "2");
  Q_EMIT form->addAsked();
  EXPECT_TRUE(p.waitFor([&] { return editor->text().contains("pre(2)"); }));
  const auto plan = p.experiment().parse(editor->text().toStdString());
  ASSERT_TRUE(plan) << plan.error().message;
  ASSERT_EQ(plan->conditions.size(), 4u);
  EXPECT_EQ(plan->conditions[3].name, "pre(2): TRL, threshold 50");
  EXPECT_EQ(plan->conditions[3].configuration.parameters.get("policy.threshold"), 50);
  EXPECT_EQ(plan->conditions[3].preLearning->pool, 5);
  choose("Environment of the condition", "cliff");
  p.named<QLineEdit>("Length of a life")->setText("2.5");
  EXPECT_FALSE(form->toml()) << "episodes are whole";
}

TEST(ExperimentPage, TheTableIsCopied) {
  Page p;
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
