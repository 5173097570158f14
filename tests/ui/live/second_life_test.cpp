// SPDX-License-Identifier: GPL-3.0-or-later
// A second life beside the first in the Signals layout.
#include "tests/ui/live/signalling.h"
#include "ui/live/rival.h"
#include "ui/live/world/world_view.h"

namespace surefoot {

namespace {

/// Two lives from one moment of a fall, the second greedy.
struct WhatIf : Signalling {
  WhatIf() {
    learn(60);
    looking().replayFall(0);
    looking().seek(5.0);
    QTest::qWait(60);
    moment = looking().shown().state;
    window->livePage().whatIf("sarsa", "greedy");
    EXPECT_TRUE(waitFor([&] { return window->livePage().rival() != nullptr; }));
    rival = window->livePage().rival();
    EXPECT_TRUE(waitFor([&] { return rival->session().life().snapshot().state == moment; }, 20'000));
  }
  std::vector<double> moment;
  Rival* rival = nullptr;
};

}  // namespace

TEST(SecondLife, ItsSignalsStandBesideThoseOfTheFirstOnOneClock) {
  WhatIf w;
  w.session->life().setPace(1);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.shown->second().rows() > 60 && w.shown->table().rows() > 60; }, 20'000));
  w.session->life().setRunning(false);
  QTest::qWait(200);
  const SignalTable &first = w.shown->table(), &second = w.shown->second();
  const double begins = second.column("time")->front() + w.shown->secondLater();
  const std::vector<double>& time = *first.column("time");
  const auto row = std::find_if(time.begin(), time.end(), [&](double t) { return t > begins - 1e-6; });
  ASSERT_NE(row, time.end());
  EXPECT_NEAR(*row, begins, 1e-6);
  EXPECT_EQ(first.column("pole_angle")->at(static_cast<std::size_t>(row - time.begin())), w.moment[0]);
  EXPECT_EQ(second.column("pole_angle")->front(), w.moment[0]) << "both stood so when they began";
  const std::vector<double>& episode = *second.column("episode");
  for (std::size_t at = 1; at < second.rows(); ++at)
    ASSERT_TRUE(!comesAfterAGap(second, at) || episode[at] != episode[at - 1]) << at;
  EXPECT_TRUE(w.shown->names().second.contains("Greedy", Qt::CaseInsensitive));
  EXPECT_EQ(w.charts->picture().second, &second);
  EXPECT_NE(w.charts->asCsv().find("second_pole_angle"), std::string::npos);
  w.looking().replayFall(0);
  EXPECT_EQ(w.shown->second().rows(), 0u) << "it did not live that";
  w.looking().backToLive();
  EXPECT_GT(w.shown->second().rows(), 0u);
  w.window->livePage().setComparing(false);
  EXPECT_EQ(w.shown->second().rows(), 0u);
}

// In turbo two other worlds are shown, which have nothing to do with each other.
TEST(SecondLife, IsNotComparedInTurbo) {
  WhatIf w;
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.looking().signals().rows() > 20 && !w.looking().showsLearner(); }, 20'000));
  EXPECT_EQ(w.shown->second().rows(), 0u);
}

TEST(SecondLife, BothWorldsHaveRoom) {
  WhatIf w;
  for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
    w.window->resize(size);
    w.window->livePage().useLayout(LivePage::Layout::Signals);
    QTest::qWait(100);
    for (const WorldView* world : {&w.window->livePage().world(), &w.rival->world()}) {
      EXPECT_GE(world->width(), 240) << size.width();
      EXPECT_GE(world->height(), 220) << size.width();
    }
  }
}

}  // namespace surefoot
