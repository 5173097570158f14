// SPDX-License-Identifier: GPL-3.0-or-later
// A window in the Signals layout.
#pragma once

#include "tests/ui/window_setup.h"
#include "ui/live/live_page.h"
#include "ui/live/signals/signals_bar.h"
#include "ui/live/signals/signals_shown.h"
#include "ui/live/signals/strip_charts.h"

namespace surefoot {

struct Signalling : Window {
  explicit Signalling(const std::string& policy = "epsilon-greedy", std::optional<std::int64_t> episodes = std::nullopt)
      : Window(policy, episodes) {
    window->livePage().useLayout(LivePage::Layout::Signals);
    shown = window->findChild<SignalsShown*>();
    charts = window->findChild<StripCharts*>();
    bar = window->findChild<SignalsBar*>();
  }
  Looking& looking() { return session->looking(); }
  void learn(std::int64_t episodes) {
    session->life().setTurbo(true);
    session->life().setRunning(true);
    EXPECT_TRUE(waitFor([&] { return session->life().snapshot().totals.episodes > episodes; }, 60'000));
    session->life().setRunning(false);
    session->life().setTurbo(false);
    EXPECT_TRUE(waitFor([&] { return session->life().values() && !session->life().snapshot().running; }));
    QTest::qWait(200);
  }
  SignalsShown* shown;
  StripCharts* charts;
  SignalsBar* bar;
};

}  // namespace surefoot
