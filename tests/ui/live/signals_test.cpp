// SPDX-License-Identifier: GPL-3.0-or-later
// The Signals layout: strip charts, phase portrait, strides, a second Q-function.
#include <QFile>
#include <QTemporaryDir>
#include <cmath>

#include "core/experiment/experiment.h"
#include "core/saved/q_file.h"
#include "core/signals/rollout.h"
#include "tests/ui/live/signalling.h"
#include "ui/live/signals/phase_portrait.h"
#include "ui/live/signals/stride_table.h"

namespace surefoot {

namespace {

void expectEqual(const SignalTable& a, const SignalTable& b, std::size_t rows) {
  ASSERT_EQ(a.signals().size(), b.signals().size());
  ASSERT_GE(a.rows(), rows);
  ASSERT_GE(b.rows(), rows);
  for (std::size_t i = 0; i < a.signals().size(); ++i)
    for (std::size_t row = 0; row < rows; ++row) {
      const double x = a.columns()[i][row], y = b.columns()[i][row];
      ASSERT_TRUE(x == y || (std::isnan(x) && std::isnan(y))) << a.signals()[i].key << " in row " << row;
    }
}

/// Saves the Q-function of a life's values as a file.
std::string savedQ(Signalling& w, const QTemporaryDir& folder) {
  const std::string path = folder.filePath("q.safetensors").toStdString();
  std::atomic<bool> done = false;
  w.session->life().visit([&, configuration = w.session->life().configuration()](const Life& life) {
    QFile file(QString::fromStdString(path));
    if (file.open(QIODevice::WriteOnly)) {
      const std::string bytes = qFileOf(life, configuration).write();
      file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    }
    done = true;
  });
  EXPECT_TRUE(w.waitFor([&] { return done.load(); }));
  return path;
}

}  // namespace

TEST(Signals, TheLastSecondsOfTheWorldAreWrittenDown) {
  Signalling w;
  w.session->life().setPace(1);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.looking().signals().rows() > 30; }, 20'000));
  w.session->life().setRunning(false);
  QTest::qWait(200);
  const SignalTable& table = w.looking().signals();
  const auto &time = *table.column("time"), &reward = *table.column("reward"), &delta = *table.column("td_error"),
             &q = *table.column("q"), &action = *table.column("action");
  const double discount = w.configuration.parameters.get("agent.discount");
  int known = 0;
  for (std::size_t row = 0; row + 1 < table.rows(); ++row) {
    EXPECT_GT(time[row + 1], time[row]);
    if (std::isnan(action[row])) continue;
    known += !std::isnan(reward[row]);
    if (std::isnan(delta[row]) || table.column("end")->at(row) != 0.0) continue;
    EXPECT_DOUBLE_EQ(delta[row], reward[row] + discount * q[row + 1] - q[row]);
  }
  EXPECT_GT(known, static_cast<int>(table.rows()) / 2) << "at real time few steps are missed";
  ASSERT_TRUE(w.looking().signalRow());
  EXPECT_EQ(*w.looking().signalRow(), table.rows() - 1);
  EXPECT_EQ(table.column("pole_angle")->back(), w.looking().shown().state[0]);
}

// What was seen of a life does not get into the table of the next, whose signals are others.
TEST(Signals, AnotherEnvironmentBeginsAnotherTable) {
  Signalling w;
  w.session->life().setPace(8);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.looking().signals().rows() > 20; }, 20'000));
  for (const char* environment : {"compass", "pendulum", "cliff"}) {
    ASSERT_TRUE(w.session->newLives().beginEnvironment(environment));
    w.session->life().setRunning(true);
    ASSERT_TRUE(w.waitFor([&] {
      const auto& state = w.session->life().task().state;
      const SignalTable& table = w.looking().signals();
      return w.session->life().configuration().names.environment == environment && table.rows() > 5 &&
             table.signals()[2].key == state[0].key;
    })) << environment;
    const SignalTable& table = w.looking().signals();
    for (const auto& column : table.columns()) ASSERT_EQ(column.size(), table.rows());
  }
}

TEST(Signals, NobodyLooksNothingIsWritten) {
  Window w;
  w.session->life().setRunning(true);
  QTest::qWait(300);
  EXPECT_EQ(w.session->looking().signals().rows(), 0u);
}

TEST(Signals, LookingChangesNoBit) {
  Signalling w("trl", 300);
  const auto alone =
      runLives(w.registry, w.configuration, {.jobs = 1, .keepRows = false, .interrupted = nullptr, .progress = {}});
  w.session->life().setPace(8);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.looking().signals().rows() > 20; }, 20'000));
  ASSERT_TRUE(w.looking().rollOut(25.0));
  w.looking().backToLive();
  w.session->life().setTurbo(true);
  QTest::qWait(200);
  w.bar->rollOut();
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().finished; }, 60'000));
  EXPECT_EQ(w.session->life().finish()->hash(), (*alone)[0].hash);
}

TEST(Signals, ARollOutIsThatOfTheCommand) {
  Signalling w;
  w.learn(300);
  w.bar->rollOut();
  ASSERT_TRUE(w.looking().playback());
  const auto environment = makeEnvironment(w.registry, w.configuration);
  const auto greedy = makePolicy(w.registry, "greedy", w.configuration.parameters);
  const Rollout own = rollOut(**environment, *w.session->life().values()->values, **greedy,
                              {.seed = 1, .steps = 5000, .discount = w.configuration.parameters.get("agent.discount")});
  expectEqual(w.looking().signals(), own.table, 5000);
  EXPECT_EQ(w.looking().playback()->frames.size(), 5000u) << "25 s of 200 steps";
  // The cursor of the charts is that of the replay.
  w.shown->seek(10.0);
  ASSERT_TRUE(w.looking().signalRow());
  QTest::qWait(100);
  EXPECT_EQ(*w.looking().signalRow(), 2000u);
  EXPECT_EQ(w.looking().shown().state[0], own.table.column("pole_angle")->at(2000));
  QTest::keyClick(w.charts, Qt::Key_Right);
  EXPECT_TRUE(w.waitFor([&] { return w.looking().signalRow() == 2001u; })) << "by keys as well";
}

TEST(Signals, OfAFallAreThoseOfItsReplay) {
  Signalling w;
  w.learn(50);
  ASSERT_FALSE(w.looking().falls().empty());
  w.looking().replayFall(w.looking().falls().size() - 1);
  ASSERT_TRUE(w.looking().playback());
  const Playback& p = *w.looking().playback();
  ASSERT_EQ(p.signals.rows(), p.frames.size());
  for (std::size_t i = 0; i < p.frames.size(); ++i) {
    EXPECT_EQ(p.frames[i].state[0], p.signals.column("pole_angle")->at(i));
    EXPECT_EQ(p.frames[i].row - p.firstRow, static_cast<std::int64_t>(i));
  }
  EXPECT_EQ(*(p.signals.column("fall")->end() - 2), 1.0) << "the action before the last state let it fall";
  EXPECT_TRUE(std::isnan(p.signals.column("action")->back()));
}

TEST(Signals, TheSecondQFunctionLivesFromTheSameStart) {
  Signalling w;
  w.learn(300);
  const QTemporaryDir folder;
  const std::string path = savedQ(w, folder);
  w.bar->rollOut();
  w.bar->setSecond(QString::fromStdString(path));
  ASSERT_TRUE(w.waitFor([&] { return w.looking().secondSignals().rows() > 0; }));
  expectEqual(w.looking().signals(), w.looking().secondSignals(), 5000);  // the same one, from the same start
  EXPECT_EQ(w.looking().secondName(), "q.safetensors");
  const std::string csv = w.charts->asCsv();
  EXPECT_NE(csv.find("second_pole_angle"), std::string::npos);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5001);
  w.looking().backToLive();
  EXPECT_EQ(w.looking().secondSignals().rows(), 0u);
  w.looking().replayFall(0);
  EXPECT_GT(w.looking().secondSignals().rows(), 0u) << "what would it have done where the first one fell?";
  w.looking().setSecond(nullptr, {});
  EXPECT_EQ(w.looking().secondSignals().rows(), 0u);
}

TEST(Signals, AWrongSecondFileIsASentence) {
  Signalling w;
  w.learn(20);
  QStringList sentences;
  QObject::connect(w.bar, &SignalsBar::refused, [&](const QString& s) { sentences << s; });
  const QTemporaryDir folder;
  QFile file(folder.filePath("x.safetensors"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("nothing of the kind");
  file.close();
  w.bar->setSecond(file.fileName());
  w.bar->setSecond(folder.filePath("nowhere.safetensors"));
  ASSERT_TRUE(w.waitFor([&] { return !sentences.isEmpty(); }));
  EXPECT_FALSE(w.looking().hasSecond());
}

TEST(Signals, StridesOfTheCompassAreCounted) {
  Elsewhere w("compass");
  w.window->livePage().useLayout(LivePage::Layout::Signals);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().totals.episodes > 400; }, 100'000));
  w.session->life().setRunning(false);
  QTest::qWait(300);
  ASSERT_TRUE(w.session->looking().rollOut(25.0));
  auto* shown = w.window->findChild<SignalsShown*>();
  auto* table = w.window->findChild<StrideTable*>();
  const auto strides = stridesOf(w.session->looking().signals());
  const auto rows = static_cast<int>(strides.size());
  ASSERT_EQ(shown->strides().size(), strides.size());
  EXPECT_EQ(table->rowCount(), strides.empty() ? 0 : rows + 1);
  if (strides.empty()) return;
  const auto click = [&](int row) {
    table->scrollTo(table->model()->index(row, 0));
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, QPoint(40, table->rowViewportPosition(row) + 8));
  };
  click(0);
  ASSERT_TRUE(shown->band());
  EXPECT_EQ(shown->markedStride(), (MarkedStride{0, false}));
  EXPECT_EQ(shown->band()->first, strides[0].begins);
  // A second Q-function's strides stand below, each in a row of its own.
  w.session->looking().setSecond(w.session->life().values()->values->clone(), "the same");
  ASSERT_EQ(table->rowCount(), 2 * (rows + 1));
  EXPECT_EQ(table->item(rows + 1, 0)->text(), "second 1");
  EXPECT_EQ(table->item(rows + 1, 2)->text(), table->item(0, 2)->text());
  EXPECT_TRUE(table->item(rows, 0)->text().startsWith("first, mean of"));
  EXPECT_TRUE(table->item(2 * rows + 1, 0)->text().startsWith("second, mean of"));
  click(rows + 1);
  EXPECT_EQ(shown->markedStride(), (MarkedStride{0, true}));
  EXPECT_EQ(shown->band()->first, strides[0].begins);
  QTest::keyClick(table, Qt::Key_Escape);
  EXPECT_FALSE(shown->band());
}

TEST(Signals, StripsAreChosenJoinedAndKept) {
  Signalling w;
  w.learn(20);
  w.bar->rollOut();
  const auto& signals = w.shown->table().signals();
  w.shown->setUsualStrips();
  const std::vector<Strip> usual = w.shown->strips();
  EXPECT_EQ(usual, usualStrips(signals));
  EXPECT_EQ(usual.front(), Strip{"pole_angle"});
  EXPECT_EQ(usual.back(), Strip{"value"});
  EXPECT_EQ(fromSettings(toSettings({{"a", "b"}, {"c"}})), (std::vector<Strip>{{"a", "b"}, {"c"}}));
  w.shown->setStrips({{"pole_angle", "pole_rate"}, {"unknown"}, {"fall", "end"}});
  EXPECT_EQ(signalsIn(w.shown->strips()[0], signals).places.size(), 2u);
  EXPECT_TRUE(signalsIn(w.shown->strips()[1], signals).places.empty());
  EXPECT_EQ(signalsIn(w.shown->strips()[2], signals).look, StripLook::OnOff);
  QTest::qWait(50);
  EXPECT_TRUE(w.bar->note().startsWith("4 of")) << w.bar->note().toStdString();
  w.shown->setUsualStrips();
}

TEST(Signals, TheTimeIsMagnifiedAndAllOfItShownAgain) {
  Signalling w;
  w.learn(20);
  w.bar->rollOut();
  EXPECT_DOUBLE_EQ(w.shown->from(), 0.0);
  EXPECT_NEAR(w.shown->to(), 25.0, 1e-9);
  w.shown->magnify(0.5, 10.0);
  EXPECT_NEAR(w.shown->to() - w.shown->from(), 12.5, 1e-9);
  EXPECT_NEAR(w.shown->from(), 5.0, 1e-9) << "what is under the cursor stays there";
  w.shown->shift(100.0);
  EXPECT_NEAR(w.shown->to(), 25.0, 1e-9);
  QTest::keyClick(w.charts, Qt::Key_Home);
  EXPECT_TRUE(w.shown->showsAll());
}

}  // namespace surefoot
