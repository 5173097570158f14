// SPDX-License-Identifier: GPL-3.0-or-later
// Falls replayed, the last minutes looked at again, a second learner, and the panels that explain.
#include "ui/running/playback.h"

#include <QAbstractItemModel>
#include <QPushButton>

#include "tests/ui/window_setup.h"
#include "ui/controls/panel.h"
#include "ui/live/charts/learning_charts.h"
#include "ui/live/falls_list.h"
#include "ui/live/live_page.h"
#include "ui/live/rival.h"
#include "ui/live/rule_view.h"
#include "ui/live/step_view.h"

namespace surefoot {

namespace {

/// A window whose learner has fallen several times and is paused.
struct Fallen : Window {
  explicit Fallen(bool turbo = true) : Window("epsilon-greedy") {
    session->life().setTurbo(turbo);
    session->life().setPace(8);
    session->life().setRunning(true);
    EXPECT_TRUE(waitFor([&] { return session->looking().falls().size() >= 3; }, 30'000));
    session->life().setRunning(false);
    QTest::qWait(150);
  }
};

}  // namespace

TEST(Falls, AreReplayedStateByStateAsTheyWere) {
  Fallen w;
  const Fall& fall = w.session->looking().falls().front();
  const Playback p = playbackOf(fall, w.registry, w.session->life().configuration(), nullptr);
  ASSERT_EQ(p.frames.size(), fall.inputs.actions.size() + 1);
  EXPECT_GE(std::abs(p.frames.back().state[0]), 0.45 * 3.14159265358979) << "it ends fallen";
  EXPECT_LT(std::abs(p.frames[p.frames.size() - 2].state[0]), 0.45 * 3.14159265358979);
  EXPECT_TRUE(p.frames.back().flash);
}

TEST(Falls, AClickInTheListShowsOneAndThenItIsLiveAgain) {
  Fallen w;
  w.window->livePage().useLayout(LivePage::Layout::Falls);
  auto* list = w.window->findChild<FallsList*>();
  ASSERT_TRUE(list->isVisible());
  ASSERT_EQ(list->model()->rowCount(), static_cast<int>(w.session->looking().falls().size()));
  const QPoint at(30, list->rowViewportPosition(0) + 8);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, at);
  ASSERT_TRUE(w.session->looking().playback());
  EXPECT_TRUE(w.session->looking().valuesShown());
  ASSERT_TRUE(w.waitFor([&] { return w.session->looking().shown().flash; })) << "the fall itself is seen";
  ASSERT_TRUE(w.waitFor([&] { return w.session->looking().playback()->atEnd(); }));
  QTest::qWait(300);
  ASSERT_TRUE(w.session->looking().playback()) << "it stands at the fall, to be looked at";
  const double end = w.session->looking().playback()->position;
  const int row = list->currentIndex().row();
  QTest::keyClick(list, Qt::Key_Left);
  QTest::keyClick(list, Qt::Key_Left);
  ASSERT_TRUE(w.session->looking().playback());
  EXPECT_EQ(w.session->looking().playback()->position, end - 2) << "with the focus in the list ← → are the replay's";
  EXPECT_EQ(list->currentIndex().row(), row);
  EXPECT_EQ(list->currentIndex().column(), 0);
  w.key(Qt::Key_Escape);
  EXPECT_FALSE(w.session->looking().playback());
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, at);
  ASSERT_TRUE(w.session->looking().playback());
  w.key(Qt::Key_Escape);
  EXPECT_FALSE(w.session->looking().playback());
}

// What falls in a roll-out is seen for 0.2 s while the next episode goes on, as in the window.
TEST(Falls, OfARollOutAreSeenForAMoment) {
  Window w("epsilon-greedy");
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().values(); }));
  const Playback p = rolloutOf(w.registry, w.configuration, w.session->life().values()->values->clone(), 10.0, 1);
  const std::vector<double>& fall = *p.signals.column("fall");
  const auto at = static_cast<std::size_t>(std::find(fall.begin(), fall.end(), 1.0) - fall.begin());
  ASSERT_LT(at + 60, fall.size()) << "who has learned nothing falls";
  EXPECT_FALSE(p.frames[at].flash);
  for (std::size_t i = 1; i <= 40; ++i) {
    EXPECT_TRUE(p.frames[at + i].flash) << i;
    EXPECT_EQ(p.frames[at + i].pose, p.frames[at + 1].pose);
  }
  EXPECT_NE(p.frames[at + 1].pose, p.frames[at].pose);
  EXPECT_FALSE(p.frames[at + 41].flash);
  const Footage footage = footageOf(p);
  EXPECT_EQ(footage.falls[at + 40], 1);
  EXPECT_EQ(footage.rows[at + 40], static_cast<std::int64_t>(at + 40));
}

TEST(Falls, TheOneThatIsChosenInTheListStaysChosen) {
  Fallen w;
  w.window->livePage().useLayout(LivePage::Layout::Falls);
  auto* list = w.window->findChild<FallsList*>();
  const QPoint at(30, list->rowViewportPosition(1) + 8);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, at);
  const auto number = [&] { return list->model()->index(list->currentIndex().row(), 0).data().toString(); };
  const QString chosen = number();
  const std::size_t before = w.session->looking().falls().size();
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->looking().falls().size() > before + 3; }, 30'000));
  w.session->life().setRunning(false);
  EXPECT_GT(list->currentIndex().row(), 3) << "newer ones stand above it";
  EXPECT_EQ(number(), chosen);
  EXPECT_EQ(list->selectionModel()->selectedRows().value(0).row(), list->currentIndex().row());
  list->hide();
  list->show();
  EXPECT_EQ(number(), chosen);
}

TEST(Falls, LookingAtThemDoesNotTouchTheLearner) {
  const auto hashOf = [](bool looking) {
    Window w("epsilon-greedy", 600);
    w.session->life().setTurbo(true);
    w.session->life().setRunning(true);
    while (!w.session->life().finished()) {
      QTest::qWait(5);
      if (looking && !w.session->looking().falls().empty())
        w.session->looking().replayFall(w.session->looking().falls().size() / 2);
      if (looking) w.session->looking().examine(std::vector<double>{0.1, 0.2, 0.3});
    }
    return w.session->life().finish()->hash();
  };
  EXPECT_EQ(hashOf(false), hashOf(true));
}

TEST(Recording, LeftGoesBackAndRightForthAndEscapeIsLive) {
  Window w;
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().steps > 60; }));
  w.session->life().setRunning(false);
  QTest::qWait(100);
  for (int i = 0; i < 5; ++i) w.key(Qt::Key_Left);
  ASSERT_TRUE(w.session->looking().playback());
  const double back = w.session->looking().playback()->position;
  w.key(Qt::Key_Right);
  EXPECT_EQ(w.session->looking().playback()->position, back + 1);
  const std::int64_t steps = w.session->life().snapshot().steps;
  w.session->looking().seek(0);
  QTest::qWait(50);
  EXPECT_EQ(w.session->looking().shown().state, w.session->looking().playback()->frames[0].state);
  EXPECT_EQ(w.session->life().snapshot().steps, steps);
  w.key(Qt::Key_Escape);
  EXPECT_FALSE(w.session->looking().playback());
}

TEST(Recording, ItsMemoryIsBounded) {
  Recording recording;
  Shown frame;
  frame.state = frame.pose = frame.q = {1, 2, 3};
  for (std::size_t i = 0; i < Recording::kMostFrames + 100; ++i) recording.add(frame);
  EXPECT_EQ(recording.size(), Recording::kMostFrames);
  frame.q.assign(100'000, 0.0);  // 2.4 MB a frame
  recording.add(frame);
  EXPECT_LT(recording.size(), 120u);
}

TEST(Rival, RunsWithTheFirstAndLearnsByItsOwnPolicy) {
  Window w("epsilon-greedy");
  w.window->livePage().setComparing(true);
  Rival* rival = w.window->livePage().rival();
  ASSERT_TRUE(rival);
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return rival->session().life().snapshot().totals.episodes > 50; }));
  EXPECT_EQ(rival->session().life().configuration().names.policy, "softmax");
  EXPECT_EQ(rival->session().life().configuration().seed, w.session->life().configuration().seed);
  ASSERT_TRUE(w.session->editing().setParameter("policy.temperature", 3.0));
  EXPECT_EQ(rival->session().life().configuration().parameters.get("policy.temperature"), 3.0);
  w.session->life().setRunning(false);
  auto* chart = w.window->findChild<LearningChart*>();
  EXPECT_TRUE(w.waitFor([&] { return chart->asCsv().find("\nsecond,softmax,") != std::string::npos; }))
      << "its curve stands beside the first one's";
  EXPECT_FALSE(rival->session().life().running());
  ASSERT_TRUE(w.session->newLives().restart());
  EXPECT_TRUE(w.waitFor([&] { return rival->session().life().snapshot().steps == 0; }));
  w.window->livePage().setComparing(false);
  EXPECT_FALSE(w.window->livePage().rival());
}

TEST(StepView, ExplainsTheLastStepWithNumbersThatAddUp) {
  Window w;
  w.window->livePage().useLayout(LivePage::Layout::Teaching);
  auto* view = w.window->findChild<StepView*>();
  for (int i = 0; i < 3; ++i) w.key(Qt::Key_Period);
  ASSERT_TRUE(w.waitFor([&] { return view->sentences().size() > 2; }));
  const auto learned = w.session->life().snapshot().learned;
  ASSERT_EQ(learned.size(), 1u);
  EXPECT_NEAR(learned[0].step.delta(), learned[0].step.reward + learned[0].step.next - learned[0].step.before, 1e-12);
  EXPECT_TRUE(view->sentences()[1].startsWith("δ = ")) << view->sentences()[1].toStdString();
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  EXPECT_EQ(view->sentences().size(), 1) << "in turbo there is no single step";
}

TEST(RuleView, ItsButtonSetsTheThresholdToTheRules) {
  Fallen w;
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().values() && w.session->life().values()->rule; }, 30'000));
  w.session->life().setRunning(false);
  w.window->livePage().useLayout(LivePage::Layout::Teaching);
  QTest::qWait(250);
  auto* view = w.window->findChild<RuleView*>();
  QTest::mouseClick(view->findChild<QPushButton*>(), Qt::LeftButton);
  EXPECT_EQ(w.session->life().threshold(), std::round(w.session->life().values()->rule->threshold));
}

TEST(Layouts, EachCanBeUsedAndTheUsualOneComesBack) {
  Window w;
  const auto visible = [&] {
    QStringList names;
    for (const Panel* panel : w.window->livePage().panels())
      if (panel->isVisible()) names << panel->objectName();
    return names;
  };
  const QStringList usual = visible();
  for (const auto layout : {LivePage::Layout::Teaching, LivePage::Layout::Falls, LivePage::Layout::Maps}) {
    w.window->livePage().useLayout(layout);
    EXPECT_NE(visible(), usual);
  }
  w.window->livePage().useLayout(LivePage::Layout::Usual);
  EXPECT_EQ(visible(), usual);
}

}  // namespace surefoot
