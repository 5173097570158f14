// SPDX-License-Identifier: GPL-3.0-or-later
// How long a student waits: from a click on a lesson to its first step, for each lesson; from a prediction to what came
// out (200 episodes in turbo); and for LEO's two hours. Needs a display: xvfb-run lesson_bench LESSONS [leo]
#include <fmt/format.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include "tests/full_registry.h"
#include "ui/lessons/lessons_page.h"
#include "ui/lessons/taking/lesson_view.h"
#include "ui/session/session.h"
#include "ui/style/theme.h"
#include "ui/window/main_window.h"

using namespace surefoot;

namespace {

bool opens(LessonDriver& driver, std::size_t step) {
  return QTest::qWaitFor(
      [&] {
        return driver.number() == step && driver.phase() == LessonDriver::Phase::Open && !driver.text().isEmpty();
      },
      120'000);
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  applyAppearance(application, Appearance::Light);
  Registry registry = fullRegistry();
  auto configuration = configure(registry, {}, {});
  if (argc < 2 || !configuration) return 2;
  Session session(registry, *configuration, false);
  const QTemporaryDir folder;
  WindowSetup setup;
  setup.lessons = QString::fromLocal8Bit(argv[1]);
  setup.folder = folder.path();
  setup.asksOnQuit = false;
  MainWindow window(session, std::move(setup));
  window.show();
  window.setPage(2);
  QElapsedTimer clock;
  for (const ShelvedLesson& one : window.lessonsPage().lessons()) {
    if (!one.lesson) continue;
    clock.start();
    window.lessonsPage().start(one.lesson->name);
    LessonDriver& driver = window.lessonsPage().view()->driver();
    // A first step that runs to an end begins when its text is there.
    static_cast<void>(QTest::qWaitFor([&] { return !driver.text().isEmpty(); }, 30'000));
    fmt::print("{:<28} first step after {} ms\n", one.lesson->name, clock.elapsed());
    if (one.lesson->name == "exploring-costs-falls" && opens(driver, 0)) {
      driver.next();
      static_cast<void>(opens(driver, 1));
      clock.start();
      driver.say(40);
      static_cast<void>(opens(driver, 2));
      fmt::print("{:<28} what came out after {} ms\n", "", clock.elapsed());
    }
    if (argc < 3 || one.lesson->name != "leo-walks") continue;
    for (std::size_t step = 0; step < one.lesson->steps.size(); ++step) {
      clock.start();
      static_cast<void>(opens(driver, step));
      fmt::print("{:<28} step {} open after {} ms\n", "", step + 1, clock.elapsed());
      const auto& predict = one.lesson->steps[step].predict;
      predict ? driver.say((predict->low + predict->high) / 2) : driver.next();
    }
  }
  return 0;
}
