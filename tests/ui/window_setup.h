// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QTest>
// These return from a function that GoogleTest does not know of: a failure would pass in silence.
#undef QVERIFY
#undef QCOMPARE
#pragma GCC poison QVERIFY QCOMPARE

#include "tests/core/experiment/test_setup.h"
#include "ui/session/session.h"
#include "ui/window/main_window.h"

namespace surefoot {

/// A session and its window, shown, paused.
struct Window {
  explicit Window(const std::string& policy = "trl", std::optional<std::int64_t> episodes = std::nullopt,
                  const std::vector<Assignment>& assignments = {})
      : registry(fullRegistry()),
        configuration(pendulumConfiguration(registry, policy, assignments)) {
    configuration.episodes = episodes;
    session = std::make_unique<Session>(registry, configuration, false);
    window = std::make_unique<MainWindow>(*session);
    window->resize(1280, 800);
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    window->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(window.get()));
  }
  template <class Condition>
  bool waitFor(Condition condition, int milliseconds = 10'000) {
    return QTest::qWaitFor(condition, milliseconds);
  }
  void key(Qt::Key key) { QTest::keyClick(window.get(), key); }
  /// The widget that says this name to a screen reader.
  template <class W>
  W* named(const QString& name) {
    for (W* w : window->findChildren<W*>())
      if (w->accessibleName() == name) return w;
    ADD_FAILURE() << "no widget is named " << name.toStdString();
    return nullptr;
  }

  Registry registry;
  Configuration configuration;
  std::unique_ptr<Session> session;
  std::unique_ptr<MainWindow> window;
};

/// A window in another environment, which learns flat out.
struct Elsewhere : Window {
  explicit Elsewhere(const std::string& environment, const std::string& policy = "epsilon-greedy") : Window(policy) {
    EXPECT_TRUE(session->newLives().beginEnvironment(environment));
    EXPECT_TRUE(waitFor([&] { return session->life().snapshot().life == 2 && session->life().values(); }, 30'000));
    session->life().setTurbo(true);
    session->life().setRunning(true);
    EXPECT_TRUE(waitFor([&] { return session->life().snapshot().totals.episodes > 3; }, 30'000));
    QTest::qWait(300);
  }
};

}  // namespace surefoot
