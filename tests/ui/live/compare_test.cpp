// SPDX-License-Identifier: GPL-3.0-or-later
// Two learners side by side: what is held against each other is comparable, and says what it is.
#include <QPushButton>
#include <QTemporaryDir>

#include "core/experiment/experiment.h"
#include "core/files/whole_file.h"
#include "core/saved/q_file.h"
#include "tests/ui/session/learn_and_answer.h"
#include "tests/ui/window_setup.h"
#include "ui/controls/message_bar.h"
#include "ui/live/compare_strip.h"
#include "ui/live/compared_falls.h"
#include "ui/live/live_page.h"
#include "ui/live/rival.h"
#include "ui/running/beginning.h"
#include "ui/window/status_line.h"

namespace surefoot {

namespace {

RunCurve curve(const std::vector<CurvePoint>& points) {
  RunCurve c;
  c.points = points;
  return c;
}

/// A life that begins with what another one learned in scenario 2.
Configuration preLearned(Window& w) {
  Configuration simulation = w.configuration;
  simulation.names.scenario = "2";
  auto life = makeLife(w.registry, simulation, 0, false);
  for (int i = 0; i < 20'000; ++i) (*life)->step();
  Configuration reality = w.configuration;
  beginWith(reality, std::make_shared<const TensorFile>(qFileOf(**life, simulation)));
  return reality;
}

}  // namespace

TEST(Compare, FallsAreCountedAtEqualEpisodesAndEqualTime) {
  const RunCurve a = curve({{1, 10, 1, 0}, {2, 20, 2, 0}, {3, 30, 3, 0}, {4, 40, 4, 0}});
  const RunCurve b = curve({{1, 100, 0, 0}, {2, 200, 1, 0}});
  const auto episodes = fallsAtEqualEpisodes(a, b);
  ASSERT_TRUE(episodes);
  EXPECT_EQ(episodes->at, 2);
  EXPECT_EQ(episodes->first, 2);
  EXPECT_EQ(episodes->second, 1);
  const auto steps = fallsAtEqualSteps(a, b);
  ASSERT_TRUE(steps);
  EXPECT_EQ(steps->at, 40);
  EXPECT_EQ(steps->first, 4);
  EXPECT_EQ(steps->second, 0) << "its first episode is not over yet";
  EXPECT_FALSE(fallsAtEqualEpisodes(a, curve({})));
}

TEST(Compare, BothBeginAlikeAfterPreLearning) {
  Window w("epsilon-greedy");
  w.window->livePage().setComparing(true);
  Rival* rival = w.window->livePage().rival();
  ASSERT_TRUE(rival);
  ASSERT_TRUE(w.session->newLives().begin(preLearned(w)));
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 2 && rival->session().life().values(); }));
  EXPECT_EQ(w.session->life().beginning(), "pre-learned (scenario 2)");
  EXPECT_EQ(rival->session().life().beginning(), "pre-learned (scenario 2)");
  EXPECT_TRUE(rival->strip().first().contains("pre-learned (scenario 2)"));
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().values() && rival->session().life().values(); }));
  std::vector<double> mine(5), others(5);
  w.session->life().values()->values->evaluate(w.session->life().snapshot().state, Layer::Sum, mine);
  rival->session().life().values()->values->evaluate(w.session->life().snapshot().state, Layer::Sum, others);
  EXPECT_EQ(mine, others) << "the same initial Q-function";
  w.key(Qt::Key_R);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 3; }));
  EXPECT_EQ(w.session->life().beginning(), "pre-learned (scenario 2)") << "R keeps the start, and says so";
  EXPECT_TRUE(w.window->messages().accessibleName().contains("pre-learned (scenario 2)"));
  EXPECT_EQ(rival->session().life().beginning(), "pre-learned (scenario 2)");
  QTest::keyClick(w.window.get(), Qt::Key_R, Qt::ShiftModifier);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 4; }));
  EXPECT_EQ(w.session->life().beginning(), "") << "from scratch";
  EXPECT_EQ(rival->session().life().beginning(), "");
}

TEST(Compare, AStartThatCannotFitIsTold) {
  Window w("epsilon-greedy");
  ASSERT_TRUE(w.session->newLives().begin(preLearned(w)));
  w.window->livePage().setComparing(true);
  Rival* rival = w.window->livePage().rival();
  ASSERT_TRUE(rival);
  EXPECT_EQ(rival->session().life().beginning(), "pre-learned (scenario 2)");
  rival->choose("sarsa-2q", "softmax");
  EXPECT_EQ(rival->session().life().beginning(), "");
  EXPECT_TRUE(w.window->messages().accessibleName().contains("It begins empty"))
      << w.window->messages().accessibleName().toStdString();
  rival->choose("sarsa", "softmax");
  EXPECT_EQ(rival->session().life().beginning(), "pre-learned (scenario 2)");
  rival->setStart(Rival::Start::Empty);
  EXPECT_EQ(rival->session().life().beginning(), "");
}

namespace {

void learnBoth(Window& w, Rival& rival, std::int64_t episodes) {
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor(
      [&] {
        return w.session->life().progress().episodes >= episodes &&
               rival.session().life().progress().episodes >= episodes;
      },
      30'000));
  w.session->life().setRunning(false);
  ASSERT_TRUE(
      w.waitFor([&] { return !w.session->life().snapshot().running && !rival.session().life().snapshot().running; }));
  QTest::qWait(200);
}

}  // namespace

TEST(Compare, WhatTheSecondLearnedIsNotGivenUpWithoutAQuestion) {
  Window w("epsilon-greedy");
  w.window->livePage().setComparing(true);
  Rival* rival = w.window->livePage().rival();
  learnBoth(w, *rival, 30);
  const std::int64_t steps = rival->session().life().progress().steps;
  rival->choose("sarsa-2q", "softmax");
  rival->setStart(Rival::Start::Empty);
  QTest::qWait(50);
  EXPECT_EQ(rival->session().life().progress().steps, steps);
  EXPECT_EQ(rival->start(), Rival::Start::Same);
  EXPECT_EQ(rival->agent(), "sarsa");
  rival->choose("sarsa-2q", "softmax");
  answer(w, "Start again");
  EXPECT_TRUE(w.waitFor([&] { return rival->session().life().progress().steps == 0; }));
  EXPECT_EQ(rival->agent(), "sarsa-2q");
}

// Every life of the first has the one beside it that it ran with, also after changes of the second.
TEST(Compare, UndoBringsThePairBackThatRanTogether) {
  Window w("epsilon-greedy");
  w.window->livePage().setComparing(true);
  Rival* rival = w.window->livePage().rival();
  learnBoth(w, *rival, 30);
  const std::int64_t first = w.session->life().progress().steps, second = rival->session().life().progress().steps;
  w.key(Qt::Key_R);
  ASSERT_TRUE(w.waitFor(
      [&] { return w.session->life().progress().steps == 0 && rival->session().life().progress().steps == 0; }));
  learnBoth(w, *rival, 10);
  rival->choose("sarsa-2q", "softmax");
  answer(w, "Start again");
  ASSERT_TRUE(w.waitFor([&] { return rival->session().life().progress().steps == 0; }));
  w.session->history().undo().undo();
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().progress().steps == first; }));
  EXPECT_TRUE(w.waitFor([&] { return rival->session().life().progress().steps == second; }));
  EXPECT_EQ(rival->agent(), "sarsa");
}

TEST(Compare, AStartThatIsRefusedIsNotKept) {
  Window w("epsilon-greedy");
  QTemporaryDir folder;
  const QString file = folder.filePath("cliff.safetensors");
  Configuration cliff = *configure(w.registry, {.environment = "cliff", .features = "table"}, {});
  auto life = makeLife(w.registry, cliff, 0, false);
  ASSERT_TRUE(writeWhole("file", file.toStdString(), qFileOf(**life, cliff).write()));
  w.window->livePage().setComparing(true);
  Rival* rival = w.window->livePage().rival();
  rival->startWith(file);
  ASSERT_TRUE(w.waitFor([&] { return !w.window->messages().accessibleName().isEmpty(); }));
  EXPECT_EQ(rival->start(), Rival::Start::Same) << w.window->messages().accessibleName().toStdString();
  w.key(Qt::Key_R);
  ASSERT_TRUE(w.waitFor([&] {
    return w.session->life().snapshot().life == 2 && rival->session().life().snapshot().life >= 2;
  })) << "both begin again";
}

TEST(Compare, TheSecondHasParametersOfItsOwn) {
  Window w("trl");
  w.window->livePage().setComparing(true);
  Rival* rival = w.window->livePage().rival();
  const auto seconds = [&](const char* key) { return rival->session().life().configuration().parameters.get(key); };
  rival->showParameters();
  ASSERT_TRUE(rival->session().editing().setParameter("policy.threshold", 66.0));
  EXPECT_TRUE(rival->ownParameters().contains("66"));
  ASSERT_TRUE(w.session->editing().setParameter("policy.threshold", 20.0));
  EXPECT_EQ(seconds("policy.threshold"), 66.0) << "its own stays";
  ASSERT_TRUE(w.session->editing().setParameter("policy.temperature", 3.0));
  EXPECT_EQ(seconds("policy.temperature"), 3.0) << "the others follow the first";
  w.key(Qt::Key_R);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 2; }));
  EXPECT_EQ(seconds("policy.threshold"), 66.0);
}

TEST(Compare, NeitherRestNorUndoCostsTheSecondItsLife) {
  Window w("trl");
  w.window->livePage().setComparing(true);
  Rival* rival = w.window->livePage().rival();
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(
      w.waitFor([&] { return rival->session().life().progress().episodes > 50 && w.session->life().learned(); }));
  w.session->life().setRunning(false);
  ASSERT_TRUE(w.waitFor([&] { return !rival->session().life().snapshot().running; }));
  QTest::qWait(50);
  const LifeProgress second = rival->session().life().progress();
  w.window->livePage().setComparing(false);
  EXPECT_EQ(w.window->livePage().rival(), nullptr);
  w.window->livePage().setComparing(true);
  ASSERT_EQ(w.window->livePage().rival(), rival);
  EXPECT_EQ(rival->session().life().progress().steps, second.steps);
  w.key(Qt::Key_R);
  ASSERT_TRUE(w.waitFor([&] { return rival->session().life().progress().steps == 0; }));
  QTest::keyClick(w.window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(w.waitFor([&] { return rival->session().life().snapshot().steps == second.steps; }))
      << "the life beside the first comes back with it";
}

TEST(Beginning, SaysWhereTheStartIsFrom) {
  Configuration c;
  EXPECT_EQ(beginningOf(c), "");
  TensorFile file;
  file.name = "/somewhere/walks.safetensors";
  c.start = std::make_shared<const TensorFile>(file);
  EXPECT_EQ(beginningOf(c), "with walks.safetensors");
  c.beganWith = {{"learned", {{"carried_over", true}}}};
  EXPECT_EQ(beginningOf(c), "carried over");
}

}  // namespace surefoot
