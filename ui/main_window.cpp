// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCloseEvent>
#include <QFileInfo>
#include <QLabel>
#include <QSettings>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/autosave.h"
#include "ui/experiment_page.h"
#include "ui/keyboard.h"
#include "ui/live_page.h"
#include "ui/message_bar.h"
#include "ui/panel.h"
#include "ui/preferences.h"
#include "ui/session.h"
#include "ui/status_line.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"
#include "ui/world_view.h"

namespace surefoot {

MainWindow::MainWindow(Session& session, WindowSetup setup, QWidget* parent)
    : QMainWindow(parent),
      session_(session),
      appearance_(readPreferences().appearance) {
  setWindowTitle(tr("Surefoot"));
  auto* frame = new QWidget;
  auto* column = new QVBoxLayout(frame);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  new Keyboard(this);
  makeActions();
  bar_ = new RunBar(session_, run_);
  messages_ = new MessageBar(frame);
  pages_ = new QStackedWidget;
  live_ = new LivePage(session_);
  auto* live = new QWidget;
  auto* liveColumn = new QVBoxLayout(live);
  liveColumn->setContentsMargins(0, 0, 0, 0);
  liveColumn->setSpacing(0);
  liveColumn->addWidget(bar_);
  liveColumn->addWidget(live_, 1);
  pages_->addWidget(live);
  if (setup.folder.isEmpty()) setup.folder = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
  experiment_ = new ExperimentPage(session_, std::move(setup.plans), setup.folder);
  pages_->addWidget(experiment_);
  pages_->addWidget(makePlaceholder(
      tr("Lessons"), tr("Lessons that lead through exploring, thresholds and temperature will stand on this page in "
                        "a later version. The Live page is a good place to begin.")));
  column->addWidget(pages_, 1);
  status_ = new StatusLine(session_);
  column->addWidget(status_);
  setCentralWidget(frame);
  makeMenus();

  connect(live_, &LivePage::refused, messages_, &MessageBar::say);
  connect(experiment_, &ExperimentPage::refused, messages_, &MessageBar::say);
  connect(experiment_, &ExperimentPage::told, messages_, &MessageBar::tell);
  connect(experiment_, &ExperimentPage::statusChanged, this, [this](const QString& left, const QString& right) {
    experimentLeft_ = left;
    experimentRight_ = right;
    refreshStatus();
  });
  connect(&session_, &Session::stateChanged, this, &MainWindow::refresh);
  connect(&session_, &Session::stateChanged, messages_, &MessageBar::dismissRemark);
  connect(&session_, &Session::configurationChanged, messages_, &MessageBar::dismiss);
  connect(&session_, &Session::lifeReplaced, messages_, &MessageBar::dismiss);
  connect(&session_, &Session::frame, this, [this] {
    const QString trouble = toText(session_.snapshot().trouble);
    if (trouble != troubleShown_ && !trouble.isEmpty()) messages_->say(trouble);
    troubleShown_ = trouble;
    session_.setLookedAt(isVisible() && !isMinimized());
  });
  connect(&session_, &Session::refused, messages_, &MessageBar::say);
  connect(&session_.background(), &Background::busyChanged, this, [this] {
    if (session_.background().busy()) messages_->tell(tr("It is being made ready; the world goes on meanwhile."));
  });
  connect(bar_, &RunBar::meaningAsked, this, &MainWindow::showWords);
  connect(bar_, &RunBar::environmentAsked, this,
          [this](const std::string& name) { begin([this, name] { return session_.beginEnvironment(name); }); });
  connect(bar_, &RunBar::agentAsked, this, [this](const QString& name, const QString& title) {
    messages_->ask(
        tr("%1 needs a new table, so learning starts again from the beginning, with the same seed.").arg(title),
        {{tr("Start again"), [this, name] {
            if (const Status s = session_.setAgent(name.toStdString()); !s) messages_->say(toText(s.error().message));
          }}});
  });
  connect(&session_, &Session::needsNewTable, this, [this](const QString& key, double value) {
    const auto* entry = session_.configuration().parameters.find(key.toStdString());
    const auto told = [this](const Status& status) {
      if (!status) messages_->say(toText(status.error().message));
    };
    messages_->ask(
        tr("%1 = %2 needs a new table. Start again from the beginning, with the same seed, or carry what "
           "is learned over into it?")
            .arg(toText(entry->parameter.title), toText(formatValue(entry->parameter, value))),
        {{tr("Start again"),
          [this, key, value, told] { told(session_.setParameterAndRestart(key.toStdString(), value)); }},
         {tr("Carry over"), [this, key, value, told] { session_.carryOver(key.toStdString(), value, told); }}});
  });
  messages_->raise();
  refresh();
  setMinimumSize(1120, 700);
  resize(1280, 800);
  live_->world().setFocus();
  restoreSettings();
  setAcceptDrops(true);
  autosave_ = new Autosave(session_, setup.folder, this);
  usePreferences(readPreferences());
  offerToRestore();
}

QWidget* MainWindow::makePlaceholder(const QString& title, const QString& words) {
  auto* label = new QLabel(words);
  label->setAccessibleName(title);
  label->setAlignment(Qt::AlignCenter);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setForegroundRole(QPalette::PlaceholderText);
  return label;
}

void MainWindow::setPage(int page) {
  pages_->setCurrentIndex(page);
  tabs_[static_cast<std::size_t>(page)]->setChecked(true);
  for (QAction* action : liveActions_) action->setEnabled(page == 0);  // no key of one page works on another
  if (page == 0) live_->world().setFocus();
  refresh();
  refreshStatus();
}

void MainWindow::refreshStatus() {
  if (pages_->currentWidget() == experiment_)
    status_->say(experimentLeft_, experimentRight_);
  else
    status_->follow();
}

void MainWindow::refresh() {
  const QString name = sessionPath_.isEmpty() ? QString() : QFileInfo(sessionPath_).completeBaseName();
  setWindowTitle(session_.runFinished() ? tr("Surefoot: the life is complete")
                 : name.isEmpty()       ? tr("Surefoot")
                                        : tr("Surefoot: %1").arg(name));
  run_.run->setText(session_.running() ? tr("&Pause") : tr("&Run"));
  run_.run->setEnabled(!session_.runFinished() && pages_->currentIndex() == 0);
  run_.run->setToolTip(session_.runFinished() ? tr("The life is complete; restart it to run again")
                                              : tr("Run or pause"));
  const QSignalBlocker blocker(run_.turbo);
  run_.turbo->setChecked(session_.turbo());
}

void MainWindow::restoreSettings() {
  const QSettings settings;
  restoreGeometry(settings.value("geometry").toByteArray());
  live_->restoreLayout(settings.value("layout").toByteArray());
}

void MainWindow::closeForNow() {
  if (closing_) return;
  closing_ = true;
  constexpr int kPatience = 5000;  // [ms]
  QTimer::singleShot(kPatience, this, &QWidget::close);
  autosave_->leave([this] { close(); });
}

void MainWindow::closeEvent(QCloseEvent* event) {
  QSettings settings;
  settings.setValue("geometry", saveGeometry());
  settings.setValue("layout", live_->layoutState());
  autosave_->finish();
  event->accept();
}

}  // namespace surefoot
