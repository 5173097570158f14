// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window.h"

#include <QAbstractButton>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDialog>
#include <QGridLayout>
#include <QLabel>
#include <QMenuBar>
#include <QPainter>
#include <QSettings>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QVBoxLayout>

#include "ui/experiment_page.h"
#include "ui/live_page.h"
#include "ui/message_bar.h"
#include "ui/panel.h"
#include "ui/session.h"
#include "ui/status_line.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"
#include "ui/world_view.h"

namespace surefoot {

namespace {

/// A page's name at the right end of the menu; a line below the one that is shown.
class PageTab final : public QAbstractButton {
 public:
  PageTab(const QString& text, QWidget* parent) : QAbstractButton(parent) {
    setText(text);
    setAccessibleName(text);
    setCheckable(true);
    setAutoExclusive(true);
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
    setFixedSize(static_cast<int>(QFontMetricsF(textFont(13, 500)).horizontalAdvance(text)) + 20, 24);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Theme& t = themeOf(*this);
    QPainter p(this);
    p.setFont(textFont(13, isChecked() ? 500 : 400));
    p.setPen(isChecked() || underMouse() ? t.ink : t.quiet);
    p.drawText(rect().adjusted(0, 0, 0, -2), Qt::AlignCenter, text());
    if (isChecked()) p.fillRect(QRect(10, height() - 3, width() - 20, 2), t.ink);
    if (hasFocus()) {
      p.setPen(QPen(t.accent, 2));
      p.drawRect(rect().adjusted(1, 1, -1, -1));
    }
  }
};

}  // namespace

MainWindow::MainWindow(Session& session, WindowSetup setup, QWidget* parent) : QMainWindow(parent), session_(session) {
  setWindowTitle(tr("Surefoot"));
  auto* frame = new QWidget;
  auto* column = new QVBoxLayout(frame);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
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
  connect(experiment_, &ExperimentPage::told, messages_, &MessageBar::say);
  connect(experiment_, &ExperimentPage::statusChanged, this, [this](const QString& left, const QString& right) {
    experimentLeft_ = left;
    experimentRight_ = right;
    refreshStatus();
  });
  connect(&session_, &Session::stateChanged, this, &MainWindow::refresh);
  connect(&session_, &Session::configurationChanged, messages_, &MessageBar::dismiss);
  connect(&session_, &Session::lifeReplaced, messages_, &MessageBar::dismiss);
  connect(&session_, &Session::frame, this, [this] {
    const QString trouble = toText(session_.snapshot().trouble);
    if (trouble != troubleShown_ && !trouble.isEmpty()) messages_->say(trouble);
    troubleShown_ = trouble;
    session_.setLookedAt(isVisible() && !isMinimized());
  });
  connect(bar_, &RunBar::agentAsked, this, [this](const QString& name, const QString& title) {
    messages_->ask(
        tr("%1 needs a new table, so learning starts again from the beginning, with the same seed.").arg(title),
        tr("Start again"), [this, name] {
          if (const Status s = session_.setAgent(name.toStdString()); !s) messages_->say(toText(s.error().message));
        });
  });
  connect(&session_, &Session::needsNewTable, this, [this](const QString& key, double value) {
    const auto* entry = session_.configuration().parameters.find(key.toStdString());
    messages_->ask(tr("%1 = %2 needs a new table, so learning starts again from the beginning, with the same seed.")
                       .arg(toText(entry->parameter.title), toText(formatValue(entry->parameter, value))),
                   tr("Start again"), [this, key, value] {
                     if (const Status s = session_.setParameterAndRestart(key.toStdString(), value); !s)
                       messages_->say(toText(s.error().message));
                   });
  });
  messages_->raise();
  refresh();
  setMinimumSize(1120, 700);
  resize(1280, 800);
  live_->world().setFocus();
  restoreSettings();
}

QAction* MainWindow::addAction(QMenu* menu, const QString& text, const QString& tip, const QKeySequence& key) {
  auto* action = new QAction(text, this);
  action->setToolTip(tip);
  action->setShortcut(key);
  if (menu) menu->addAction(action);
  QMainWindow::addAction(action);
  if (!key.isEmpty()) shortcuts_.push_back(action);
  return action;
}

void MainWindow::makeActions() {
  run_.run = addAction(nullptr, tr("&Run"), tr("Run or pause"), Qt::Key_Space);
  run_.step = addAction(nullptr, tr("&Step"), tr("One step of the paused world"), {});
  run_.step->setShortcuts({Qt::Key_Period, Qt::Key_Right});
  shortcuts_.push_back(run_.step);
  run_.restart = addAction(nullptr, tr("Re&start"), tr("Start the life again with the same seed"), Qt::Key_R);
  run_.turbo = addAction(nullptr, tr("&Turbo"), tr("Learn flat out"), Qt::Key_T);
  run_.turbo->setCheckable(true);
  run_.faster = addAction(nullptr, tr("&Faster"), tr("A notch faster"), {});
  run_.faster->setShortcuts({Qt::Key_Plus, Qt::Key_Equal});
  run_.slower = addAction(nullptr, tr("S&lower"), tr("A notch slower"), Qt::Key_Minus);
  shortcuts_.push_back(run_.faster);
  connect(run_.run, &QAction::triggered, &session_, [this] { session_.setRunning(!session_.running()); });
  connect(run_.step, &QAction::triggered, &session_, &Session::stepOnce);
  connect(run_.restart, &QAction::triggered, this, [this] {
    if (const Status s = session_.restart(); !s) messages_->say(toText(s.error().message));
  });
  connect(run_.turbo, &QAction::toggled, &session_, &Session::setTurbo);
  connect(run_.faster, &QAction::triggered, this, [this] { bar_->changePace(+1); });
  connect(run_.slower, &QAction::triggered, this, [this] { bar_->changePace(-1); });
}

void MainWindow::makeMenus() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  QAction* quit = addAction(file, tr("&Quit"), tr("Leave the program"), QKeySequence(Qt::CTRL | Qt::Key_Q));
  connect(quit, &QAction::triggered, this, &QWidget::close);

  QMenu* view = menuBar()->addMenu(tr("&View"));
  for (Panel* panel : live_->panels()) view->addAction(panel->toggleViewAction());
  view->addSeparator();
  connect(addAction(view, tr("Reset &layout"), tr("Put every panel back in its place"), {}), &QAction::triggered, live_,
          &LivePage::resetLayout);
  connect(addAction(view, tr("&Fit the world"), tr("The zoom that shows the whole world"), Qt::Key_Home),
          &QAction::triggered, this, [this] { live_->world().fit(); });
  view->addSeparator();
  auto* group = new QActionGroup(this);
  const int saved = QSettings().value("appearance", 0).toInt();
  for (const auto& [text, appearance] :
       {std::pair{tr("Colours of the &system"), Appearance::System}, std::pair{tr("L&ight"), Appearance::Light},
        std::pair{tr("&Dark"), Appearance::Dark}}) {
    QAction* action = addAction(view, text, text, {});
    action->setCheckable(true);
    action->setChecked(saved == static_cast<int>(appearance));
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, appearance = appearance] { setAppearance(appearance); });
  }
  view->addSeparator();
  QAction* fullScreen = addAction(view, tr("F&ull screen"), tr("The whole screen"), Qt::Key_F11);
  fullScreen->setCheckable(true);
  connect(fullScreen, &QAction::toggled, this, [this](bool on) { on ? showFullScreen() : showNormal(); });

  QMenu* run = menuBar()->addMenu(tr("&Run"));
  for (QAction* action : {run_.run, run_.step, run_.restart}) run->addAction(action);
  run->addSeparator();
  for (QAction* action : {run_.turbo, run_.faster, run_.slower}) run->addAction(action);

  QMenu* experiment = menuBar()->addMenu(tr("&Experiment"));
  const auto item = [&](const QString& text, const QString& tip, void (ExperimentPage::*slot)()) {
    QAction* action = addAction(experiment, text, tip, {});
    connect(action, &QAction::triggered, this, [this, slot] {
      setPage(1);
      (experiment_->*slot)();
    });
  };
  item(tr("&Open a plan or results …"), tr("A plan, a recipe or a store of results"), &ExperimentPage::openWithDialog);
  item(tr("Save the &plan as …"), tr("The plan as a file"), &ExperimentPage::savePlanAs);
  experiment->addSeparator();
  item(tr("&Run or pause"), tr("Run the experiment, or pause it"), &ExperimentPage::runOrPause);
  item(tr("Start &again"), tr("Forget what was lived"), &ExperimentPage::startAgain);
  experiment->addSeparator();
  item(tr("&Copy the table as CSV"), tr("To the clipboard"), &ExperimentPage::copyCsv);
  item(tr("Copy the table as &LaTeX"), tr("To the clipboard"), &ExperimentPage::copyLatex);
  item(tr("E&xport all lives as CSV …"), tr("Conditions, lives and episodes"), &ExperimentPage::exportCsv);
  item(tr("Export all c&harts …"), tr("PNG, PDF and CSV"), &ExperimentPage::exportCharts);

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  connect(addAction(help, tr("&Shortcuts"), tr("All shortcuts"), Qt::Key_F1), &QAction::triggered, this,
          &MainWindow::showShortcuts);
  connect(addAction(help, tr("&About Surefoot"), tr("What this is"), {}), &QAction::triggered, this,
          &MainWindow::showAbout);
  menuBar()->setCornerWidget(makeTabs());
}

QWidget* MainWindow::makeTabs() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 2, 0);
  row->setSpacing(0);
  for (const QString& title : {tr("Live"), tr("Experiment"), tr("Lessons")}) {
    auto* tab = new PageTab(title, box);
    const int page = static_cast<int>(tabs_.size());
    connect(tab, &QAbstractButton::clicked, this, [this, page] { setPage(page); });
    row->addWidget(tab);
    tabs_.push_back(tab);
  }
  tabs_.front()->setChecked(true);
  return box;
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
  refreshStatus();
}

void MainWindow::refreshStatus() {
  if (pages_->currentWidget() == experiment_)
    status_->say(experimentLeft_, experimentRight_);
  else
    status_->follow();
}

void MainWindow::refresh() {
  setWindowTitle(session_.runFinished() ? tr("Surefoot: the life is complete") : tr("Surefoot"));
  run_.run->setText(session_.running() ? tr("&Pause") : tr("&Run"));
  run_.run->setEnabled(!session_.runFinished());
  run_.run->setToolTip(session_.runFinished() ? tr("The life is complete; restart it to run again")
                                              : tr("Run or pause"));
  const QSignalBlocker blocker(run_.turbo);
  run_.turbo->setChecked(session_.turbo());
}

void MainWindow::setAppearance(Appearance appearance) {
  QSettings().setValue("appearance", static_cast<int>(appearance));
  applyAppearance(*qApp, appearance);
}

void MainWindow::restoreSettings() {
  const QSettings settings;
  restoreGeometry(settings.value("geometry").toByteArray());
  live_->restoreLayout(settings.value("layout").toByteArray());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  QSettings settings;
  settings.setValue("geometry", saveGeometry());
  settings.setValue("layout", live_->layoutState());
  event->accept();
}

void MainWindow::showShortcuts() {
  auto* dialog = new QDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Shortcuts"));
  auto* grid = new QGridLayout(dialog);
  grid->setContentsMargins(24, 20, 24, 20);
  grid->setHorizontalSpacing(32);
  int row = 0;
  for (const QAction* action : shortcuts_) {
    QStringList keys;
    for (const QKeySequence& key : action->shortcuts()) keys << key.toString(QKeySequence::NativeText);
    auto* label = new QLabel(keys.join(tr(" or ")));
    label->setFont(textFont(13, 500));
    grid->addWidget(label, row, 0);
    grid->addWidget(new QLabel(action->toolTip()), row++, 1);
  }
  dialog->show();
}

void MainWindow::showAbout() {
  auto* dialog = new QDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("About Surefoot"));
  auto* column = new QVBoxLayout(dialog);
  column->setContentsMargins(24, 20, 24, 20);
  auto* text = new QLabel(
      tr("<p style='font-size:18px'>Surefoot %1</p><p>Reinforcement learning that avoids falling.</p>"
         "<p>The methods are those of M. van Diepen's thesis<br><i>Avoiding failure states during Reinforcement "
         "Learning</i>, Delft.</p><p>Free software under the GNU General Public License, version 3 or later.</p>")
          .arg(QApplication::applicationVersion()));
  column->addWidget(text);
  dialog->show();
}

}  // namespace surefoot
