// SPDX-License-Identifier: GPL-3.0-or-later
// Learning for a while, and pressing an answer of the message bar.
#pragma once

#include <QPushButton>

#include "tests/ui/window_setup.h"
#include "ui/controls/message_bar.h"

namespace surefoot {

/// The buttons of the message bar.
inline QStringList answersOf(MainWindow& window) {
  QStringList texts;
  for (auto* button : window.messages().findChildren<QPushButton*>())
    if (button->isVisible()) texts << button->text();
  return texts;
}
inline QStringList answersOf(Window& w) {
  return answersOf(*w.window);
}

/// Presses one of them.
inline void answer(MainWindow& window, const QString& text) {
  for (auto* button : window.messages().findChildren<QPushButton*>())
    if (button->isVisible() && button->text() == text) return QTest::mouseClick(button, Qt::LeftButton);
  ADD_FAILURE() << "no answer " << text.toStdString() << " among " << answersOf(window).join(", ").toStdString();
}
inline void answer(Window& w, const QString& text) {
  answer(*w.window, text);
}

/// Flat out until so many episodes are over; then it stands still.
inline void learn(Window& w, std::int64_t episodes) {
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().progress().episodes >= episodes; }, 30'000));
  w.session->life().setRunning(false);
  ASSERT_TRUE(w.waitFor([&] { return !w.session->life().snapshot().running; }));
  QTest::qWait(200);  // the values of the last moment
}

}  // namespace surefoot
