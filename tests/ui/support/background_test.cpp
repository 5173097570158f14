// SPDX-License-Identifier: GPL-3.0-or-later
// Work beside the window that fails is told in a sentence, and ends nothing but itself.
#include <gtest/gtest.h>

#include <QPlainTextEdit>
#include <QTemporaryDir>
#include <new>
#include <set>
#include <stdexcept>

#include "core/files/whole_file.h"
#include "core/saved/q_file.h"
#include "tests/ui/window_setup.h"
#include "ui/experiment/experiment.h"
#include "ui/experiment/experiment_page.h"
#include "ui/experiment/plan_editor.h"
#include "ui/support/background.h"

namespace surefoot {

namespace {

const char* const kShortPlan =
    "lives = 2\n[[condition]]\nname = \"a\"\nenvironment = \"cliff\"\nfeatures = \"table\"\nepisodes = 5\n";

/// Lets a test wait until nothing runs.
bool waitFor(const std::function<bool()>& condition) {
  return QTest::qWaitFor(condition, 10'000);
}

}  // namespace

TEST(Background, WhateverIsThrownIsToldAndTheNextWorkRuns) {
  Background background;
  QStringList told;
  int done = 0;
  QObject::connect(&background, &Background::failed, [&](const QString& sentence) { told << sentence; });
  for (const auto patience : {std::chrono::milliseconds(0), std::chrono::milliseconds(5000)}) {
    told.clear(), done = 0;
    background.start([](const auto&) { throw std::runtime_error("a text is expected"); }, [&] { ++done; }, patience);
    ASSERT_TRUE(waitFor([&] { return !background.busy(); }));
    background.start([](const auto&) { throw std::bad_alloc(); }, [&] { ++done; }, patience);
    ASSERT_TRUE(waitFor([&] { return !background.busy(); }));
    background.start([](const auto&) { throw 1; }, [&] { ++done; }, patience);
    ASSERT_TRUE(waitFor([&] { return !background.busy(); }));
    ASSERT_EQ(told.size(), 3);
    EXPECT_TRUE(told[0].contains("a text is expected"));
    EXPECT_TRUE(told[1].contains("memory"));
    EXPECT_EQ(done, 0) << "what follows needs what was made";
    background.start([](const auto&) {}, [&] { ++done; }, patience);
    ASSERT_TRUE(waitFor([&] { return !background.busy(); }));
    EXPECT_EQ(done, 1);
  }
}

TEST(Experiment, ResultsOfOddClaimsAndFiguresAreShownOrToldAndEndNothing) {
  const Registry registry = fullRegistry();
  LabView view;
  Evidence e;
  e.record.condition.name = "a";
  e.configuration = {{"policy", 3}, {"agent", Json::array()}, {"parameters", 1}};
  e.lives.resize(2);
  e.record.lives.resize(2);
  view.evidence = {e};
  view.findings.plan.conditions = {e.record.condition};
  view.findings.plan.conditions[0].configuration = e.configuration.dump();
  const Claim odd{.id = "X",
                  .kind = "value",
                  .says = "",
                  .arguments = {{"measure", 3}, {"conditions", Json::array({1})}, {"thesis", 5}, {"reference", true}}};
  ExperimentResults results(registry);
  results.begin({odd}, view.findings.plan);
  results.want(0, {.name = "falls", .title = "", .kind = "bars", .conditions = {}, .along = {}, .q = {}, .state = {}});
  results.show(std::make_shared<const LabView>(view));
  ASSERT_TRUE(waitFor([&] { return !results.busy() && results.view(); }));
  EXPECT_EQ(results.policyOf("a"), "");
  ASSERT_TRUE(results.figure("falls"));
  EXPECT_EQ(results.figure("falls")->series[0].policy, "");
}

TEST(Experiment, APlansOwnFigureIsNotTakenForAStandardOne) {
  const Registry registry = fullRegistry();
  QTemporaryDir folder;
  Experiment experiment(registry, {}, folder.path());
  const std::string own = "[[figure]]\nname = \"falls\"\ntitle = \"Mine\"\nkind = \"settling\"\n";
  ASSERT_TRUE(experiment.setText(kShortPlan + own));
  ASSERT_TRUE(waitFor([&] { return !experiment.isOpening(); }));
  std::set<std::string> names;
  for (const FigureSpec& figure : experiment.figures())
    EXPECT_TRUE(names.insert(figure.name).second) << figure.name << " is there twice";
  EXPECT_EQ(experiment.figures().back().title, "Mine");
  EXPECT_EQ(experiment.figures().back().name, "falls");
  EXPECT_TRUE(names.contains("falls-standard"));
}

TEST(Experiment, AClaimOfAWrongTypeIsToldWhenThePlanIsRead) {
  const Registry registry = fullRegistry();
  QTemporaryDir folder;
  Experiment experiment(registry, {}, folder.path());
  QString told;
  QObject::connect(&experiment, &Experiment::failed, [&](const QString& sentence) { told = sentence; });
  const Status s =
      experiment.setText(std::string(kShortPlan) + "[[claim]]\nid = \"X\"\nkind = \"value\"\nmeasure = 3\n");
  ASSERT_TRUE(waitFor([&] { return !experiment.isOpening(); }));
  if (!s) told = QString::fromStdString(s.error().message);
  EXPECT_TRUE(told.contains("claim X: measure: a text is expected, not 3")) << told.toStdString();
}

TEST(ExperimentPage, TheNumberOfLivesIsFoundBehindBlanks) {
  EXPECT_EQ(withLives("  lives = 3\n[[condition]]\n", 5), "  lives = 5\n[[condition]]\n");
  EXPECT_EQ(withLives("\tlives=3\n", 5), "\tlives = 5\n");
  EXPECT_EQ(withLives("# lives = 3\n", 5), "lives = 5\n# lives = 3\n");
}

TEST(ExperimentPage, ALifeThatBeganWithAFileIsAddedWithThatFile) {
  Window w;
  QTemporaryDir folder;
  const std::string path = folder.filePath("walks.safetensors").toStdString();
  ASSERT_TRUE(writeWhole("file", path, qFileOf(*lifeOf(w.registry, w.configuration), w.configuration).write()));
  w.session->files().open(path, [](const Status& s) { EXPECT_TRUE(s); });
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().configuration().start != nullptr; }));
  w.window->setPage(1);
  auto* editor = w.window->findChild<PlanEditor*>();
  auto* edit = w.named<QPlainTextEdit>("Plan");
  edit->setPlainText("");
  Q_EMIT editor->liveConditionAsked();
  ASSERT_TRUE(w.waitFor([&] { return edit->toPlainText().contains("live: trl"); }));
  EXPECT_TRUE(edit->toPlainText().contains("pre-learning.file = \"" + QString::fromStdString(path)));
  const auto plan = parsePlan(w.registry, edit->toPlainText().toStdString(), "plan", {});
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_TRUE(plan->conditions[0].configuration.start) << "it would begin with an empty table";
}

}  // namespace surefoot
