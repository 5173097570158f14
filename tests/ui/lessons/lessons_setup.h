// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTemporaryDir>

#include "core/files/read_file.h"
#include "tests/ui/window_setup.h"
#include "ui/lessons/lessons_page.h"
#include "ui/lessons/taking/lesson_view.h"

namespace surefoot {

/// A window with the program's lessons, and a folder of its own for what is kept.
struct Lessons {
  Lessons() : registry(fullRegistry()), configuration(pendulumConfiguration(registry, "trl")) {
    session = std::make_unique<Session>(registry, configuration, false);
    open();
  }
  void open() {
    WindowSetup setup;
    setup.lessons = QStringLiteral(SUREFOOT_SOURCE) + QStringLiteral("/resources/lessons");
    setup.folder = folder.path();
    setup.asksOnQuit = false;
    window = std::make_unique<MainWindow>(*session, std::move(setup));
    window->resize(1280, 800);
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    window->activateWindow();
    window->setPage(2);
  }
  LessonsPage& page() { return window->lessonsPage(); }
  LessonDriver& driver() { return page().view()->driver(); }
  bool opens(std::size_t number) {
    return QTest::qWaitFor([&] { return driver().number() == number && driver().phase() == LessonDriver::Phase::Open; },
                           20'000) &&
           QTest::qWaitFor([&] { return !driver().text().isEmpty(); }, 5'000);
  }
  void key(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWidget* target = window->focusWidget() ? window->focusWidget() : window.get();
    QTest::keyClick(target, static_cast<Qt::Key>(key), modifiers);
  }
  QTemporaryDir folder;
  Registry registry;
  Configuration configuration;
  std::unique_ptr<Session> session;
  std::unique_ptr<MainWindow> window;
};

}  // namespace surefoot
