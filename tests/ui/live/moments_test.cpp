// SPDX-License-Identifier: GPL-3.0-or-later
// A life goes on from a moment that was lived before, and a second one beside it.
#include "core/saved/journal.h"
#include "tests/ui/live/signalling.h"
#include "ui/live/rival.h"

namespace surefoot {

// From a moment of a fall, by the button's command; the journal of that life is lived again to its hash.
TEST(Moments, TheLearnerGoesOnFromAReplay) {
  Signalling w;
  w.learn(60);
  ASSERT_FALSE(w.looking().falls().empty());
  EXPECT_FALSE(w.looking().momentShown()) << "nothing is shown again";
  const Fall fall = w.looking().falls().back();
  w.looking().replayFall(w.looking().falls().size() - 1);
  w.looking().seek(10.0);
  QTest::qWait(60);
  const std::vector<double> pose = w.looking().shown().pose;
  w.window->livePage().goOn();
  EXPECT_FALSE(w.looking().playback());
  ASSERT_TRUE(w.waitFor([&] { return w.looking().shown().pose == pose; })) << "exactly where it was";
  w.session->life().setRunning(true);
  w.session->life().setTurbo(true);
  const std::int64_t episodes = w.session->life().snapshot().totals.episodes;
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().totals.episodes > episodes + 20; }, 30'000));
  w.session->life().setRunning(false);
  w.looking().replayFall(w.looking().falls().size() - 1);
  w.looking().seek(1e9);
  EXPECT_FALSE(w.looking().momentShown()) << "there the episode is over";
  const Configuration began = w.session->life().began();
  const auto life = w.session->life().finish();
  ASSERT_TRUE(
      std::any_of(life->changes().begin(), life->changes().end(), [](const Change& c) { return c.key == "go_on"; }));
  LifeResult result = summarise(*life, 0, 0.0);
  result.changes = life->changes();
  const auto journal = parseJournal(w.registry, journalOf(began, result), "j");
  ASSERT_TRUE(journal) << journal.error().message;
  const auto again = replay(w.registry, *journal, {});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->hash, life->hash());
}

TEST(Moments, OfTheLastMinutesAsWell) {
  Signalling w;
  w.session->life().setPace(1);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.looking().signals().rows() > 60; }, 20'000));
  w.session->life().setRunning(false);
  QTest::qWait(150);
  w.looking().lookBack(-1);
  ASSERT_TRUE(w.waitFor([&] { return static_cast<bool>(w.looking().momentShown()); }, 3000));
  const Playback& p = *w.looking().playback();  // a pose may be that of a fall that was a moment ago
  const std::vector<double> state = p.frames[static_cast<std::size_t>(p.position)].state;
  w.window->livePage().goOn();
  EXPECT_TRUE(w.waitFor([&] { return w.looking().shown().state == state; }));
}

TEST(Moments, AnotherModelOfThenIsRefused) {
  Signalling w;
  w.learn(60);
  w.looking().replayFall(0);
  w.looking().seek(3.0);
  ASSERT_TRUE(w.looking().momentShown());
  ASSERT_TRUE(w.session->life().setParameter("environment.damping", 0.003));
  w.looking().replayFall(0);
  w.looking().seek(3.0);
  const auto moment = w.looking().momentShown();
  ASSERT_FALSE(moment);
  EXPECT_NE(moment.error().message.find("environment.damping"), std::string::npos) << moment.error().message;
}

// Two lives from one moment: with nothing else different they stay the same but for their draws; with a greedy policy
// the second acts greedily from the first step on.
TEST(Moments, WhatIfSetsASecondLifeIntoTheSameMoment) {
  Signalling w;
  w.learn(60);
  w.looking().replayFall(0);
  w.looking().seek(5.0);
  QTest::qWait(60);
  const std::vector<double> pose = w.looking().shown().pose;
  w.window->livePage().whatIf("sarsa", "greedy");
  ASSERT_TRUE(w.waitFor([&] { return w.window->livePage().rival() != nullptr; }));
  Rival& rival = *w.window->livePage().rival();
  ASSERT_TRUE(w.waitFor([&] { return rival.session().life().snapshot().pose == pose; }, 20'000));
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().pose == pose; }));
  EXPECT_EQ(rival.policy(), "greedy");
  EXPECT_EQ(rival.session().life().snapshot().q, w.session->life().snapshot().q) << "what the first knows now";
}

// A second that has learned something is asked for first; until then the first stays where it is.
TEST(Moments, WhatIfAsksBeforeAnyoneIsMoved) {
  Signalling w;
  w.learn(60);
  w.window->livePage().setComparing(true);
  Rival& rival = *w.window->livePage().rival();
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return rival.session().life().snapshot().totals.episodes > 3; }, 30'000));
  w.session->life().setRunning(false);
  QTest::qWait(200);
  w.looking().replayFall(0);
  w.looking().seek(5.0);
  QTest::qWait(60);
  const std::vector<double> state = w.looking().shown().state;
  std::function<void()> accept;
  QObject::connect(&w.window->livePage(), &LivePage::newTableAsked,
                   [&](const QString&, const std::function<void()>& goOn) { accept = goOn; });
  w.window->livePage().whatIf("sarsa", "greedy");
  ASSERT_TRUE(w.waitFor([&] { return static_cast<bool>(accept); }));
  QTest::qWait(100);
  EXPECT_NE(w.session->life().snapshot().state, state);
  accept();
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().snapshot().state == state; }));
  EXPECT_TRUE(w.waitFor([&] { return rival.session().life().snapshot().state == state; }, 20'000));
}

}  // namespace surefoot
