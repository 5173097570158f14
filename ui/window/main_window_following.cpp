// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the window that follows a file which another process writes: results on the Experiment page, a life on
// the Live page.
#include <QAction>
#include <QStackedWidget>

#include "core/saved/followable.h"
#include "ui/controls/link_button.h"
#include "ui/controls/message_bar.h"
#include "ui/controls/notice_strip.h"
#include "ui/experiment/experiment_page.h"
#include "ui/session/life_follower.h"
#include "ui/style/symbol_text.h"
#include "ui/support/ask_for_file.h"
#include "ui/window/main_window.h"

namespace surefoot {

void MainWindow::addFollowing(QMenu* file) {
  QAction* follow =
      addAction(file, tr("Fo&llow …"), tr("Look at results or a checkpoint while another process writes them"), {});
  stopFollowing_ = addAction(file, tr("S&top following"), tr("What was followed stays, as if it had been opened"), {});
  connect(follow, &QAction::triggered, this, &MainWindow::followWithDialog);
  connect(stopFollowing_, &QAction::triggered, this, &MainWindow::stopFollowing);
}

void MainWindow::makeFollowing() {
  follower_ = new LifeFollower(session_, this);
  goOnFromHere_ = following_->addLink(tr("Go on from here"),
                                      tr("Learn on, as a life of your own; the file is not followed any more"),
                                      [this] { follower_->goOn(); });
  following_->addLink(tr("Stop following"), tr("The life stays as it is, as one of your own"),
                      [this] { follower_->stop(); });
  connect(follower_, &LifeFollower::changed, this, &MainWindow::showFollowing);
  connect(&experiment_->experiment(), &Experiment::stateChanged, this, &MainWindow::showFollowing);
  connect(follower_, &LifeFollower::becameOnesOwn, this, [this](const QString& name) {
    messages_->tell(tr("%1 is not followed any more. This is a life of your own now, not saved yet.").arg(name));
  });
  showFollowing();
}

void MainWindow::follow(const QString& path) {
  const auto what = followableAt(path.toStdString());
  if (!what) return messages_->say(toText(what.error().message));
  stopFollowing();
  if (*what == Followable::Store)
    experiment_->follow(path);
  else
    follower_->follow(path.toStdString());
  setPage(*what == Followable::Store ? 1 : 0);
  if (*what == Followable::Store) experiment_->setFocus(Qt::OtherFocusReason);
}

void MainWindow::stopFollowing() {
  follower_->stop();
  experiment_->stopFollowing();
}

void MainWindow::followWithDialog() {
  askForFile(this, tr("Follow"),
             tr("Results and checkpoints (*.sqlite* *.safetensors *.surefoot *.ckpt);;All files (*)"),
             [this](const QString& path) { follow(path); });
}

void MainWindow::showFollowing() {
  const Following* file = follower_->following();
  following_->say(file ? tr("Following %1, read only").arg(file->name()) : QString(), follower_->text(),
                  file && file->warns());
  goOnFromHere_->setEnabled(file && file->isShown());
  stopFollowing_->setEnabled(file || experiment_->experiment().following());
}

}  // namespace surefoot
