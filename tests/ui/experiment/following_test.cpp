// SPDX-License-Identifier: GPL-3.0-or-later
// A store that another process writes, looked at from the Experiment page.
#include <QMenu>
#include <QProcess>
#include <QScrollBar>
#include <filesystem>
#include <map>

#include "core/files/read_file.h"
#include "core/store/store_lock.h"
#include "tests/ui/experiment/experiment_window.h"
#include "ui/controls/link_button.h"
#include "ui/controls/notice_strip.h"
#include "ui/experiment/figure_panel.h"
#include "ui/experiment/figures/figure_view.h"
#include "ui/experiment/findings_table.h"

namespace surefoot {

namespace {

namespace fs = std::filesystem;

/// Some seconds of lives.
const std::string kGrowing =
    "title = \"It grows\"\nlives = 8\nreference = \"one\"\n[base]\nminutes = 25\n[[condition]]\nname = \"one\"\n"
    "[[condition]]\nname = \"two\"\npolicy = \"softmax\"\n";

/// Every file of a folder with its bytes.
std::map<std::string, std::string> contentsOf(const QTemporaryDir& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder.path().toStdString()))
    files[entry.path().filename().string()] = readFile(entry.path().string()).value();
  return files;
}

struct Followed : Window {
  Followed() : page(window->experimentPage()), path(folder.filePath("results.sqlite")) {}
  Experiment& experiment() { return page.experiment(); }
  std::string store() const { return path.toStdString(); }
  QString text() { return experiment().followingText(); }
  bool says(const char* words, int milliseconds = 20'000) {
    return waitFor([&] { return text().contains(words); }, milliseconds);
  }
  Store make(const std::string& plan, const std::string& where) {
    const auto parsed = parsePlan(registry, plan, "plan.toml", {});
    return std::move(*Store::create(where, *planToStore(registry, *parsed)));
  }
  /// A store of this plan with all its lives.
  void live(const std::string& plan, const std::string& where) {
    Store store = make(plan, where);
    EXPECT_TRUE(runPlan(registry, *parsePlan(registry, plan, "plan.toml", {}), store, {}));
  }
  /// A process that writes the store.
  void start(QProcess& process) {
    const QString plan = folder.filePath("plan.toml");
    ASSERT_TRUE(writeWhole("plan", plan.toStdString(), kGrowing));
    process.start(SUREFOOT_PROGRAM, {"experiment", plan, "--jobs", "1", "--out", path});
    ASSERT_TRUE(process.waitForStarted());
  }

  ExperimentPage& page;
  QTemporaryDir folder;
  QString path;
};

}  // namespace

TEST(Following, ShowsAStoreWhileAnotherProcessWritesItAndEndsWithItsTable) {
  Followed w;
  w.window->follow(w.path);
  EXPECT_EQ(w.experiment().state(), State::Following);
  ASSERT_TRUE(w.says("not there yet"));
  QProcess process;
  w.start(process);
  ASSERT_TRUE(w.waitFor([&] { return w.experiment().view() && w.experiment().livesShown() > 0; }, 60'000));
  EXPECT_EQ(w.experiment().title(), "It grows");
  const int first = w.experiment().livesShown();
  EXPECT_LT(first, 16) << "it was looked at while it grew";

  // What was chosen stays chosen while the rest comes.
  w.experiment().choose("two");
  FigurePanel* panel = w.page.figures().front();
  for (LinkButton* button : panel->findChildren<LinkButton*>()) {
    if (!button->menu()) continue;
    Q_EMIT button->menu()->aboutToShow();
    for (QAction* action : button->menu()->actions())
      if (action->text() == "Cumulative falls") action->trigger();
  }
  auto* table = w.page.findChild<FindingsTable*>();
  int planChanges = 0;
  QObject::connect(&w.experiment(), &Experiment::planChanged, [&] { ++planChanges; });

  ASSERT_TRUE(w.waitFor([&] { return w.experiment().livesShown() == 16; }, 100'000));
  ASSERT_TRUE(w.waitFor([&] { return process.state() == QProcess::NotRunning; }, 30'000));
  ASSERT_TRUE(w.says("all lives are there"));
  EXPECT_EQ(planChanges, 0);
  EXPECT_EQ(w.experiment().chosen(), "two");
  ASSERT_FALSE(table->selectedItems().isEmpty());
  EXPECT_EQ(table->selectedItems().front()->text(), "two");
  EXPECT_EQ(panel->findChild<FigureView*>()->figure().name, "cumulative-falls");
  const auto store = Store::open(w.store());
  ASSERT_TRUE(store) << store.error().message;
  EXPECT_EQ(findingsAsCsv(w.experiment().view()->findings), findingsAsCsv(viewOf(w.registry, *store)->findings));
  EXPECT_FALSE(w.experiment().canRun());
}

TEST(Following, LeavesNoTraceBesideAProcessThatIsThereOrWasKilled) {
  Followed w;
  {
    Store store = w.make(kPlan, w.store());  // this process holds it, and its log
    ASSERT_TRUE(store.save({.life = 0, .episodes = 0, .diverged = {}, .livesVersion = 1, .program = "1"}, {}, {}));
    const auto before = contentsOf(w.folder);
    ASSERT_TRUE(before.contains("results.sqlite-wal"));
    w.window->follow(w.path);
    ASSERT_TRUE(w.says("1 of 12"));
    EXPECT_TRUE(w.text().contains("being written")) << w.text().toStdString();
    QTest::qWait(1500);
    EXPECT_EQ(contentsOf(w.folder), before);
  }
  ASSERT_TRUE(w.says("no process writes it"));
  w.window->stopFollowing();
  ASSERT_TRUE(fs::remove(w.store()));

  QProcess process;
  w.start(process);
  ASSERT_TRUE(w.waitFor([&] { return fs::exists(w.store() + "-wal"); }, 30'000));
  QTest::qWait(600);
  process.kill();
  ASSERT_TRUE(process.waitForFinished());
  ASSERT_TRUE(fs::exists(w.store() + "-wal"));
  const auto left = contentsOf(w.folder);
  w.window->follow(w.path);
  ASSERT_TRUE(w.says("no process writes it now"));
  QTest::qWait(1500);
  EXPECT_EQ(contentsOf(w.folder), left);
  const auto peeked = Store::peek(w.store());
  ASSERT_TRUE(peeked) << peeked.error().message;
  EXPECT_EQ(static_cast<std::size_t>(w.experiment().livesDone()), peeked->lives()->size());
  EXPECT_EQ(contentsOf(w.folder), left);
}

TEST(Following, AFileThatIsMissingBrokenGoneOrReplacedIsToldAndLookedForOn) {
  Followed w;
  int refusals = 0;
  QObject::connect(&w.page, &ExperimentPage::refused, [&] { ++refusals; });
  const std::string spare = w.folder.filePath("spare").toStdString();
  w.window->follow(w.path);
  ASSERT_TRUE(w.says("not there yet"));
  ASSERT_TRUE(writeWhole("file", w.store(), ""));
  QTest::qWait(1500);
  EXPECT_TRUE(w.text().contains("not there yet")) << w.text().toStdString();
  ASSERT_TRUE(writeWhole("file", w.store(), "no store, this"));
  ASSERT_TRUE(w.says("not a store of results")) << w.text().toStdString();

  w.live(kPlan, spare);
  fs::rename(spare, w.store());
  ASSERT_TRUE(w.says("all lives are there")) << w.text().toStdString();
  ASSERT_TRUE(w.waitFor([&] { return w.experiment().livesShown() == 12; }));
  fs::resize_file(w.store(), fs::file_size(w.store()) / 2);
  ASSERT_TRUE(w.says("What it held before is shown")) << w.text().toStdString();
  EXPECT_EQ(w.experiment().livesShown(), 12);
  fs::remove(w.store());
  ASSERT_TRUE(w.says("It is gone")) << w.text().toStdString();

  w.make(kGrowing, spare);
  fs::rename(spare, w.store());
  ASSERT_TRUE(w.says("no life is over yet")) << w.text().toStdString();
  EXPECT_EQ(w.experiment().title(), "It grows");
  EXPECT_EQ(w.experiment().livesDone(), 0);
  EXPECT_EQ(refusals, 0) << "the line says it, again and again; messages would pile up";
}

TEST(Following, AStoreOfARecipeHasItsClaims) {
  Followed w;
  const std::string recipe = w.folder.filePath("recipe.toml").toStdString();
  ASSERT_TRUE(writeWhole("recipe", recipe,
                         kPlan + "[[claim]]\nid = \"X1\"\nkind = \"value\"\nconditions = [\"one\"]\nthesis = 5\n"));
  w.live(kPlan, w.store());
  PlanSource listed{.title = "Two walks", .path = recipe};
  listed.recipe = true;
  Experiment experiment(w.registry, {listed}, w.folder.path());
  experiment.follow(w.store());
  ASSERT_TRUE(w.waitFor([&] { return experiment.judgements().size() == 1; }))
      << experiment.followingText().toStdString();
  EXPECT_EQ(experiment.claims().front().id, "X1");
}

TEST(Following, EndsWhenAskedToOrWhenSomethingElseIsOpened) {
  Followed w;
  w.live(kPlan, w.store());
  w.window->follow(w.path);
  ASSERT_TRUE(w.says("all lives are there"));
  ASSERT_TRUE(w.waitFor([&] { return w.experiment().view() != nullptr; }));
  const auto* strip = w.page.findChild<NoticeStrip*>();
  EXPECT_TRUE(strip->isVisible());
  EXPECT_TRUE(strip->said().startsWith("Following results.sqlite, read only")) << strip->said().toStdString();
  EXPECT_FALSE(w.experiment().run()) << "it is only looked at";
  w.window->stopFollowing();
  EXPECT_FALSE(strip->isVisible());
  EXPECT_EQ(w.experiment().state(), State::Complete);
  EXPECT_TRUE(w.experiment().view());

  w.window->follow(w.path);
  ASSERT_TRUE(w.says("all lives are there"));
  const QString plan = w.folder.filePath("other.toml");
  ASSERT_TRUE(writeWhole("plan", plan.toStdString(), kGrowing));
  w.page.open(plan);
  ASSERT_TRUE(w.waitFor([&] { return w.experiment().state() == State::Ready; }));
  EXPECT_FALSE(w.experiment().following());
  w.window->follow(plan);
  EXPECT_FALSE(w.experiment().following()) << "a plan is nothing that grows";
}

}  // namespace surefoot
