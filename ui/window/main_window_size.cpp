// SPDX-License-Identifier: GPL-3.0-or-later
// How large the window is, and where its message bar stands.
#include <QGuiApplication>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/controls/message_bar.h"
#include "ui/lessons/lessons_page.h"
#include "ui/live/live_page.h"
#include "ui/style/scale.h"
#include "ui/window/main_window.h"

namespace surefoot {

namespace {
constexpr QSize kSmallest(800, 500), kUsual(1280, 800);  // [px]
}  // namespace

void MainWindow::restoreSettings() {
  const QSettings settings;
  setMinimumSize(kSmallest);
  resize(scaled(kUsual));
  restoreGeometry(settings.value("geometry").toByteArray());
  live_->restoreLayout(settings.value("layout").toByteArray());
  fitToScreen();
  fitted_ = size();
}

void MainWindow::fitToScreen() {
  if (isMaximized() || isFullScreen()) return;
  const QRect room = screen()->availableGeometry();
  const QSize frame = frameGeometry().size() - size();  // nothing before the window manager has drawn it
  setMinimumSize(kSmallest.boundedTo(room.size() - frame));
  const QSize most = (room.size() - frame).expandedTo(minimumSize());
  if (width() > most.width() || height() > most.height()) resize(size().boundedTo(most));
  const QRect whole = frameGeometry();
  const int x = std::max(room.left(), std::min(whole.x(), room.right() + 1 - whole.width()));
  const int y = std::max(room.top(), std::min(whole.y(), room.bottom() + 1 - whole.height()));
  if (QPoint(x, y) != whole.topLeft()) move(x, y);
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  constexpr int kFrameDrawn = 150;  // [ms] by the window manager
  if (fitted_.isEmpty()) return;
  QTimer::singleShot(kFrameDrawn, this, [this] {
    if (size() == fitted_) fitToScreen();
    fitted_ = {};
  });
}

void MainWindow::placeMessages() {
  QWidget* page = pages_->currentWidget() == lessons_ ? lessons_->currentWidget() : pages_->currentWidget();
  auto* column = qobject_cast<QVBoxLayout*>(page->layout());
  const bool shown = !messages_->isHidden();
  const int toolbars = pages_->currentIndex() == 0 ? 1 : 2;
  if (column) column->insertWidget(toolbars, messages_);
  messages_->setVisible(shown);
}

}  // namespace surefoot
