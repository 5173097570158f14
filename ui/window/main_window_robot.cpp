// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window about robots of one's own: the page, and the way from a text to the Live page.
#include <QStackedWidget>

#include "ui/controls/message_bar.h"
#include "ui/robot/robot_page.h"
#include "ui/session/session.h"
#include "ui/style/symbol_text.h"
#include "ui/window/main_window.h"

namespace surefoot {

void MainWindow::makeRobot(const WindowSetup& setup) {
  robot_ = new RobotPage(session_.life().registry(), setup.folder);
  pages_->addWidget(robot_);
  connect(robot_, &RobotPage::refused, this, [this](const QString& sentence) { messages_->say(sentence); });
  connect(robot_, &RobotPage::told, this, [this](const QString& sentence) { messages_->tell(sentence); });
  connect(robot_, &RobotPage::statusChanged, this, [this](const QString& left, const QString& right) {
    robotLeft_ = left;
    robotRight_ = right;
    refreshStatus();
  });
  // The life of the Live page is kept for undo, as whenever another one begins.
  connect(robot_, &RobotPage::learnAsked, this, [this](const std::string& environment) {
    if (const Status s = session_.newLives().beginEnvironment(environment); !s)
      return messages_->say(toText(s.error().message));
    setPage(0);
    if (!session_.life().running()) session_.life().setRunning(true);
  });
}

bool MainWindow::onRobotPage() const {
  return pages_->currentIndex() == kRobotPage;
}

void MainWindow::openRobot(const QString& path) {
  setPage(kRobotPage);
  robot_->open(path);
}

}  // namespace surefoot
