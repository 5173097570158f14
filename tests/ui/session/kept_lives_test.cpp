// SPDX-License-Identifier: GPL-3.0-or-later
// No life that has learned something is lost: what ends it can be undone, or asks.
#include <QPushButton>
#include <QTemporaryDir>

#include "core/experiment/experiment.h"
#include "core/saved/q_file.h"
#include "tests/ui/session/learn_and_answer.h"
#include "tests/ui/window_setup.h"
#include "ui/controls/message_bar.h"
#include "ui/session/session_name.h"

namespace surefoot {

namespace {

/// R, and the new life is there: on a busy machine it takes a moment.
void restart(Window& w) {
  w.key(Qt::Key_R);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().progress().steps == 0; }, 30'000));
}

void undo(Window& w) {
  QTest::keyClick(w.window.get(), Qt::Key_Z, Qt::ControlModifier);
}
void redo(Window& w) {
  QTest::keyClick(w.window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
}

/// Everything that begins another life.
struct Way {
  const char* name;
  std::function<void(Window&, const QString& folder)> go;
};

void openWhatWasLearned(Window& w, const QString& folder, SavedAs what, const char* name) {
  const QString path = folder + '/' + name;
  bool written = false;
  w.session->files().save(what, path.toStdString(), [&](const Status& s) { written = static_cast<bool>(s); });
  ASSERT_TRUE(w.waitFor([&] { return written; }));
  w.window->openFile(path);
}

std::vector<Way> ways() {
  return {
      {"the key R", [](Window& w, const QString&) { w.key(Qt::Key_R); }},
      {"an empty table", [](Window& w, const QString&) { ASSERT_TRUE(w.session->newLives().restartEmpty()); }},
      {"another environment",
       [](Window& w, const QString&) { ASSERT_TRUE(w.session->newLives().beginEnvironment("cliff")); }},
      {"the same environment",
       [](Window& w, const QString&) { ASSERT_TRUE(w.session->newLives().beginEnvironment("pendulum")); }},
      {"another seed", [](Window& w, const QString&) { ASSERT_TRUE(w.session->newLives().setSeed(99)); }},
      {"another learning rule",
       [](Window& w, const QString&) { ASSERT_TRUE(w.session->newLives().setAgent("sarsa-2q")); }},
      {"a parameter that needs a table",
       [](Window& w, const QString&) {
         ASSERT_TRUE(w.session->newLives().setParameterAndRestart("features.tilings", 8));
       }},
      {"what was carried over",
       [](Window& w, const QString&) {
         bool done = false;
         w.session->newLives().carryOver("features.pole_angle", 10,
                                         [&](const Status& s) { done = static_cast<bool>(s); });
         ASSERT_TRUE(w.waitFor([&] { return done; }, 60'000));
       }},
      {"a Q-function",
       [](Window& w, const QString& folder) { openWhatWasLearned(w, folder, SavedAs::QFunction, "q.safetensors"); }},
      {"a session",
       [](Window& w, const QString& folder) { openWhatWasLearned(w, folder, SavedAs::Session, "s.surefoot"); }},
      {"a journal",
       [](Window& w, const QString& folder) { openWhatWasLearned(w, folder, SavedAs::Journal, "j.jsonl"); }},
  };
}

}  // namespace

TEST(KeptLives, WhateverEndsALifeIsUndone) {
  for (const Way& way : ways()) {
    SCOPED_TRACE(way.name);
    Window w("trl");
    QTemporaryDir folder;
    learn(w, 120);
    ASSERT_TRUE(w.session->editing().setParameter("policy.threshold", 33.0));
    const LifeProgress before = w.session->life().progress();
    const auto falls = w.session->looking().falls().size();
    int kept = 0;
    QObject::connect(&w.session->history(), &History::lifeKept, w.window.get(), [&] { ++kept; });
    way.go(w, folder.path());
    ASSERT_TRUE(w.waitFor([&] { return kept == 1; }, 60'000)) << "the life before is within reach of undo";
    EXPECT_TRUE(w.window->messages().accessibleName().contains("Ctrl+Z brings it back"))
        << w.window->messages().accessibleName().toStdString();
    undo(w);
    ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps == before.steps; }));
    EXPECT_EQ(w.session->life().snapshot().totals.episodes, before.episodes);
    EXPECT_EQ(w.session->looking().falls().size(), falls);
    EXPECT_EQ(w.session->life().configuration().names.environment, "pendulum");
    EXPECT_EQ(w.session->life().configuration().names.agent, "sarsa");
    EXPECT_EQ(w.session->life().configuration().seed, w.configuration.seed);
    EXPECT_EQ(w.session->life().configuration().parameters.get("policy.threshold"), 33.0);
    ASSERT_TRUE(w.waitFor([&] {
      const auto& points = w.session->life().curves().live().points;
      return !points.empty() && points.back().episode == before.episodes && points.front().episode == 1;
    })) << "its whole curve";
    EXPECT_EQ(w.session->life().curves().live().number, 1);
    undo(w);  // the change of that life, made before
    EXPECT_NE(w.session->life().configuration().parameters.get("policy.threshold"), 33.0);
  }
}

// Kept in the middle of an episode, brought back, run on: the same bits as if nothing had happened.
TEST(KeptLives, ALifeThatWasBroughtBackGoesOnBitForBit) {
  Window w("trl", 400);
  const auto alone =
      runLives(w.registry, w.configuration, {.jobs = 1, .keepRows = false, .interrupted = nullptr, .progress = {}});
  learn(w, 100);
  w.key(Qt::Key_R);
  learn(w, 50);
  undo(w);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().finished && w.session->life().snapshot().life == 3; },
                        60'000));
  EXPECT_EQ(w.session->life().finish()->hash(), (*alone)[0].hash);
}

TEST(KeptLives, RedoGoesForwardAgain) {
  Window w;
  learn(w, 60);
  const std::int64_t first = w.session->life().progress().steps;
  w.key(Qt::Key_R);
  learn(w, 30);
  const std::int64_t second = w.session->life().progress().steps;
  ASSERT_NE(first, second);
  for (int i = 0; i < 2; ++i) {
    undo(w);
    EXPECT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps == first; }));
    redo(w);
    EXPECT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps == second; }));
  }
  EXPECT_EQ(w.session->life().curves().live().number, 2);
  ASSERT_EQ(w.session->life().curves().earlier().size(), 1u);
  EXPECT_EQ(w.session->life().curves().earlier()[0].number, 1);
}

// A change ends what could be made again; the life in it must not go with it.
TEST(KeptLives, AChangeAfterUndoDoesNotCostTheOtherLife) {
  Window w;
  learn(w, 60);
  w.key(Qt::Key_R);
  learn(w, 30);
  const std::int64_t second = w.session->life().progress().steps;
  undo(w);
  ASSERT_TRUE(w.session->editing().setParameter("policy.threshold", 20.0));
  undo(w);
  undo(w);
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps == second; }));
}

TEST(KeptLives, ManyRestartsDoNotPushTheLearnedLifeOut) {
  Window w;
  learn(w, 300);
  const std::int64_t first = w.session->life().progress().steps;
  for (int i = 0; i < 20; ++i) {
    restart(w);
    learn(w, 2);
  }
  EXPECT_EQ(w.session->history().unsavedBefore().size(), 20u) << "there is room for all of them";
  for (int i = 0; i < 20 && w.session->life().progress().steps != first; ++i) {
    undo(w);
    QTest::qWait(60);
  }
  EXPECT_EQ(w.session->life().progress().steps, first);
}

TEST(KeptLives, WhereThereIsNoMemoryALearnedLifeIsNotEndedWithoutAQuestion) {
  Window w;
  w.session->history().setMostKept(0);
  learn(w, 60);
  const std::int64_t steps = w.session->life().progress().steps;
  w.key(Qt::Key_R);
  QTest::qWait(50);
  EXPECT_EQ(w.session->life().progress().steps, steps) << "it is still there";
  EXPECT_TRUE(w.window->messages().accessibleName().contains("memory"));
  for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Escape}) w.key(key);
  EXPECT_EQ(w.session->life().progress().steps, steps);
  w.key(Qt::Key_R);
  for (auto* button : w.window->messages().findChildren<QPushButton*>())
    if (button->isVisible() && button->text() == "End it") QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_TRUE(
      w.waitFor([&] { return w.session->life().snapshot().life == 2 && w.session->life().snapshot().steps == 0; }));
}

// … nor does one more life push one out that is kept already and not saved.
TEST(KeptLives, WhereThereIsNoMemoryForOneMoreTheWindowAsksWhichLifeEnds) {
  Window w;
  learn(w, 300);
  restart(w);
  ASSERT_EQ(w.session->history().unsavedBefore().size(), 1u);
  w.session->history().setMostKept(3 * w.session->history().lastKept()->known.bytes / 2 + (8u << 20));
  learn(w, 2);
  const std::int64_t steps = w.session->life().progress().steps;
  w.key(Qt::Key_R);
  QTest::qWait(50);
  EXPECT_EQ(w.session->life().progress().steps, steps) << "it waits for the answer";
  EXPECT_TRUE(w.window->messages().accessibleName().contains("before this one, of"))
      << w.window->messages().accessibleName().toStdString();
  EXPECT_EQ(w.session->history().unsavedBefore().size(), 1u);
  for (auto* button : w.window->messages().findChildren<QPushButton*>())
    if (button->isVisible() && button->text() == "End it") QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 3; }));
  ASSERT_EQ(w.session->history().unsavedBefore().size(), 1u);
  EXPECT_EQ(w.session->history().unsavedBefore()[0]->known.progress.steps, steps) << "the other one made room";
}

TEST(KeptLives, ATableThatGrowsCountsAsItIs) {
  Window w;
  ASSERT_TRUE(w.session->newLives().beginEnvironment("leo"));
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 2 && w.session->life().values(); }, 30'000));
  const std::size_t empty = w.session->life().values()->values->bytes();
  learn(w, 40);
  const std::size_t grown = w.session->life().values()->values->bytes();
  ASSERT_GT(grown, empty);
  ASSERT_TRUE(w.session->newLives().restart());
  ASSERT_TRUE(w.waitFor([&] { return w.session->history().lastKept() != nullptr; }));
  EXPECT_GE(w.session->history().lastKept()->known.bytes, grown);
}

// Reset is one change of many; what could be made again is not lost by it.
TEST(KeptLives, ResetAllLeavesTheUndoneLifeWithinReach) {
  Window w("trl");
  learn(w, 20);
  restart(w);
  learn(w, 60);
  const std::int64_t second = w.session->life().progress().steps;
  undo(w);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().progress().steps != second; }));
  ASSERT_TRUE(w.session->editing().setParameter("policy.threshold", 33.0));
  undo(w);
  for (auto* button : w.window->findChildren<QAbstractButton*>())
    if (button->text().contains("Reset all")) button->click();
  for (int i = 0; i < 6 && w.session->life().progress().steps != second; ++i) {
    undo(w);
    QTest::qWait(60);
  }
  EXPECT_EQ(w.session->life().progress().steps, second);
}

TEST(KeptLives, TheCurvesBeforeComeBackWithALifeOfAnotherEnvironment) {
  Window w;
  learn(w, 20);
  restart(w);
  learn(w, 20);
  restart(w);  // the third has learned nothing
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 3; }));
  ASSERT_EQ(w.session->life().curves().earlier().size(), 2u);
  ASSERT_TRUE(w.session->newLives().beginEnvironment("cliff"));
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().configuration().names.environment == "cliff"; }));
  undo(w);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().configuration().names.environment == "pendulum"; }));
  EXPECT_EQ(w.session->life().curves().earlier().size(), 1u) << "the first is beside the second again";
}

TEST(KeptLives, ALifeThatLearnedNothingGoesQuietly) {
  Window w;
  w.session->history().setMostKept(0);
  w.session->looking().stepOnce();
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps == 1; }));
  w.key(Qt::Key_R);
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 2; }));
  EXPECT_FALSE(w.window->messages().isVisible());
}

TEST(KeptLives, TheMarkSaysWhetherAnythingIsUnsaved) {
  Window w;
  QTemporaryDir folder;
  const auto* name = w.window->findChild<SessionName*>();
  ASSERT_NE(name, nullptr);
  EXPECT_EQ(name->text(), "untitled session");
  EXPECT_FALSE(w.window->isWindowModified());
  learn(w, 20);
  EXPECT_EQ(name->text(), "untitled session*");
  EXPECT_TRUE(w.window->isWindowModified());
  const QString tip = name->toolTip();
  learn(w, w.session->life().progress().episodes + 30);
  EXPECT_TRUE(w.waitFor([&] { return name->toolTip() != tip; })) << "it counts: " << tip.toStdString();
  const QString path = folder.filePath("walks.surefoot");
  w.window->saveTo(SavedAs::Session, path);
  ASSERT_TRUE(w.waitFor([&] { return name->text() == "walks"; }));
  EXPECT_FALSE(w.window->isWindowModified());
  learn(w, w.session->life().progress().episodes + 5);
  EXPECT_EQ(name->text(), "walks*");
  EXPECT_EQ(w.window->windowTitle(), "Surefoot: walks[*]");
  w.key(Qt::Key_R);
  EXPECT_EQ(name->text(), "untitled session") << "another life has no file yet";
  undo(w);
  EXPECT_EQ(name->text(), "walks*");
}

}  // namespace surefoot
