// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QUndoGroup>
#include <QVBoxLayout>

#include "ui/controls/message_bar.h"
#include "ui/controls/notice_strip.h"
#include "ui/controls/panel.h"
#include "ui/controls/preferences.h"
#include "ui/crash/crash_notes.h"
#include "ui/crash/life_notes.h"
#include "ui/experiment/experiment_page.h"
#include "ui/lessons/lessons_page.h"
#include "ui/live/live_page.h"
#include "ui/live/world/world_view.h"
#include "ui/robot/robot_page.h"
#include "ui/session/session.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/focus_home.h"
#include "ui/support/keyboard.h"
#include "ui/window/autosave.h"
#include "ui/window/status_line.h"

namespace surefoot {

MainWindow::MainWindow(Session& session, WindowSetup setup, QWidget* parent)
    : QMainWindow(parent),
      session_(session),
      appearance_(readPreferences().appearance),
      makeHandbook_(std::move(setup.handbook)),
      pictures_(setup.pictures),
      about_(setup.about),
      asksOnQuit_(setup.asksOnQuit) {
  applyTextSize(readPreferences().textSize);
  setWindowTitle(tr("Surefoot"));
  auto* frame = new QWidget;
  auto* column = new QVBoxLayout(frame);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  new Keyboard(this);
  new FocusHome(
      this, [this] { focusHome(); }, [this] { return messages_->cancel(); },
      [this](const QWidget& field) {
        return live_->isAncestorOf(&field) ||
               (qobject_cast<const QAbstractSpinBox*>(&field) && !lessons_->isAncestorOf(&field));
      });
  makeActions();
  bar_ = new RunBar(session_.life(), session_.editing(), run_);
  messages_ = new MessageBar(frame);
  pages_ = new QStackedWidget;
  live_ = new LivePage(session_);
  auto* scroll = new QScrollArea;  // on the smallest screens
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(live_);
  auto* live = new QWidget;
  auto* liveColumn = new QVBoxLayout(live);
  liveColumn->setContentsMargins(0, 0, 0, 0);
  liveColumn->setSpacing(0);
  liveColumn->addWidget(bar_);
  liveColumn->addWidget(following_ = new NoticeStrip);
  liveColumn->addWidget(scroll, 1);
  pages_->addWidget(live);
  if (setup.folder.isEmpty()) setup.folder = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
  experiment_ = new ExperimentPage(session_.life(), std::move(setup.plans), setup.folder);
  pages_->addWidget(experiment_);
  makeLessons(setup);
  makeRobot(setup);
  column->addWidget(pages_, 1);
  status_ = new StatusLine(session_.life());
  column->addWidget(status_);
  setCentralWidget(frame);
  makeMenus();

  connect(live_, &LivePage::refused, messages_, &MessageBar::say);
  connect(experiment_, &ExperimentPage::refused, messages_, &MessageBar::say);
  connect(experiment_, &ExperimentPage::told, messages_, &MessageBar::tell);
  connect(experiment_, &ExperimentPage::asked, this,
          [this](const QString& why, const QString& answer, const std::function<void()>& go) {
            messages_->ask(why, {{answer, go}});
          });
  connect(experiment_, &ExperimentPage::statusChanged, this, [this](const QString& left, const QString& right) {
    experimentLeft_ = left;
    experimentRight_ = right;
    refreshStatus();
  });
  connect(&session_.life(), &RunningLife::stateChanged, this, &MainWindow::refresh);
  connect(&session_.life(), &RunningLife::stateChanged, messages_, &MessageBar::dismissRemark);
  connect(&session_.life(), &RunningLife::configurationChanged, messages_, &MessageBar::dismiss);
  connect(&session_.life(), &RunningLife::replaced, messages_, &MessageBar::dismiss);
  connect(&session_.looking(), &Looking::frame, this, [this] {
    const QString trouble = toText(session_.life().snapshot().trouble);
    if (trouble != troubleShown_ && !trouble.isEmpty()) messages_->say(trouble);
    troubleShown_ = trouble;
    tellUnanswered();
    session_.life().setLookedAt(isVisible() && !isMinimized());
  });
  connect(bar_, &RunBar::meaningAsked, this, &MainWindow::showWords);
  askQuestions();
  makeFollowing();
  placeMessages();
  refresh();
  live_->world().setFocus();
  restoreSettings();
  setAcceptDrops(true);
  folder_ = setup.folder;
  autosave_ = new Autosave(session_.life(), session_.history(), session_.files(), folder_, this);
  usePreferences(readPreferences());
  noteChangesOf(session_.life());
  offerToRestore();
  offerReport();
}

void MainWindow::setPage(int page) {
  if (page == kRobotPage)
    if (const auto& file = session_.life().configuration().environmentFile) robot_->offer(*file);
  pages_->setCurrentIndex(page);
  noteCommand("page " + tabs_[static_cast<std::size_t>(page)]->text().toStdString());
  tabs_[static_cast<std::size_t>(page)]->setChecked(true);
  placeMessages();
  for (QAction* action : liveActions_) action->setEnabled(page == 0);  // no key of one page works on another
  undoOfPage_->setActiveStack(page >= kLessonsPage ? nullptr : &session_.history().undo());
  for (QAction* action : {undo_, redo_})
    if (page == kRobotPage) action->setEnabled(true);  // of its text, which tells nobody whether there is anything
  if (page != 1) focusHome();
  refresh();
  refreshStatus();
}

void MainWindow::focusHome() {
  if (pages_->currentIndex() == 0 && live_->world().isVisible())
    live_->world().setFocus(Qt::OtherFocusReason);
  else if (pages_->currentWidget() == lessons_)
    lessons_->focusHome();
  else if (pages_->currentWidget() == robot_)
    robot_->focusHome();
  else
    pages_->currentWidget()->setFocus(Qt::OtherFocusReason);
}

void MainWindow::refreshStatus() {
  if (pages_->currentWidget() == experiment_)
    status_->say(experimentLeft_, experimentRight_);
  else if (pages_->currentWidget() == lessons_)
    status_->say(lessonsLeft_, lessonsRight_);
  else if (pages_->currentWidget() == robot_)
    status_->say(robotLeft_, robotRight_);
  else
    status_->follow();
}

void MainWindow::refresh() {
  refreshTitle();
  run_.run->setText(session_.life().running() ? tr("&Pause") : tr("&Run"));
  run_.run->setEnabled(!session_.life().finished() && pages_->currentIndex() == 0);
  run_.run->setToolTip(session_.life().finished() ? tr("The life is complete; restart it to run again")
                                                  : tr("Run or pause"));
  const QString beginning = session_.life().beginning();
  run_.restart->setToolTip(beginning.isEmpty()
                               ? tr("Start the life again with the same seed")
                               : tr("Start the life again with the same seed and the same start: %1").arg(beginning));
  const QSignalBlocker blocker(run_.turbo);
  run_.turbo->setChecked(session_.life().turbo());
}

void MainWindow::tellHowItBegan() {
  if (const QString beginning = session_.life().beginning(); !beginning.isEmpty())
    messages_->tell(tr("The life begins again with the same start: %1. Run › Restart with an empty table begins from "
                       "nothing.")
                        .arg(beginning));
}

}  // namespace surefoot

#include "moc_main_window.cpp"
