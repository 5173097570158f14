// SPDX-License-Identifier: GPL-3.0-or-later
// A robot that a program moves, in the window.
#include <signal.h>

#include <QAbstractButton>
#include <QTemporaryDir>
#include <filesystem>

#include "core/environment_programs.h"
#include "physics/robot/child/child_robot.h"
#include "tests/ui/session/learn_and_answer.h"
#include "ui/robot/robot_page.h"

namespace surefoot {

namespace {

const std::filesystem::path kPrograms = std::filesystem::path(SUREFOOT_SOURCE) / "resources" / "robots" / "child";

/// The window with a life of the car, whose program nobody has allowed.
struct CarWindow : Window {
  CarWindow() {
    registry.programs->setModules(kPrograms.string());
    std::filesystem::copy(kPrograms, folder.filePath("car").toStdString());
    session->life().setTurbo(true);
    EXPECT_TRUE(session->newLives().beginEnvironment(folder.filePath("car/car.toml").toStdString()));
    EXPECT_TRUE(waitFor([&] { return session->life().snapshot().life == 2; }));
  }
  bool asks(const QString& what) {
    return waitFor([&] { return answersOf(*window).contains(what); });
  }
  std::int64_t episodes() { return session->life().snapshot().totals.episodes; }
  /// Of the program; asked on the learner's thread.
  int program() {
    std::atomic<int> id = -1;
    session->life().visit(
        [&](const Life& life) { id = static_cast<const ChildRobot&>(life.environment()).programId(); });
    EXPECT_TRUE(waitFor([&] { return id >= 0; }));
    return id;
  }

  QTemporaryDir folder;
};

}  // namespace

TEST(ProgramInWindow, IsAskedForBeforeItStartsAndTriedAgainWhenItEnds) {
  CarWindow w;
  ASSERT_TRUE(w.asks("Allow it, and go on"));
  EXPECT_EQ(w.session->life().snapshot().steps, 0);
  EXPECT_FALSE(w.session->life().running());
  answer(w, "Allow it, and go on");
  ASSERT_TRUE(w.waitFor([&] { return w.episodes() > 3; }));
  ::kill(-w.program(), SIGKILL);
  ASSERT_TRUE(w.asks("Try again"));
  EXPECT_FALSE(w.session->life().running());
  const std::int64_t before = w.episodes();
  answer(w, "Try again");
  EXPECT_TRUE(w.waitFor([&] { return w.episodes() > before + 3; }));
  EXPECT_TRUE(w.session->life().running());
}

TEST(ProgramInWindow, RunTriesAgainToo) {
  CarWindow w;
  ASSERT_TRUE(w.asks("Allow it, and go on"));
  w.registry.programs->allowAll();
  w.session->life().setRunning(true);
  EXPECT_TRUE(w.waitFor([&] { return w.episodes() > 3; }));
}

TEST(ProgramInWindow, TheRobotPageSaysThatItStartsOne) {
  CarWindow w;
  w.window->openFile(w.folder.filePath("car/car.toml"));
  RobotPage& page = w.window->robotPage();
  const auto button = [&](const QString& text) -> QAbstractButton* {
    for (auto* b : page.findChildren<QAbstractButton*>())
      if (b->text() == text) return b;
    return nullptr;
  };
  ASSERT_TRUE(w.waitFor([&] { return !page.isChecking() && button("Allow it to start")->isVisible(); }));
  EXPECT_FALSE(button("Try")->isEnabled());
  EXPECT_TRUE(button("Let it learn")->isEnabled());
  QTest::mouseClick(button("Allow it to start"), Qt::LeftButton);
  EXPECT_TRUE(w.waitFor([&] { return !page.isChecking() && !button("Allow it to start")->isVisible(); }));
}

}  // namespace surefoot
