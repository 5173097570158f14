// SPDX-License-Identifier: GPL-3.0-or-later
// The menus of the window with their actions, and its page tabs.
#include <QAbstractButton>
#include <QApplication>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QPainter>
#include <QUndoGroup>

#include "ui/controls/message_bar.h"
#include "ui/controls/panel.h"
#include "ui/crash/crash_notes.h"
#include "ui/experiment/experiment_page.h"
#include "ui/language/from_core.h"
#include "ui/lessons/lessons_page.h"
#include "ui/live/live_page.h"
#include "ui/live/world/world_view.h"
#include "ui/session/session.h"
#include "ui/session/session_name.h"
#include "ui/style/painted.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/ask_for_file.h"
#include "ui/window/main_window.h"

namespace surefoot {

namespace {

/// A page's name at the right end of the menu bar; the shown page has a line below its name.
class PageTab final : public Painted<QAbstractButton> {
 public:
  PageTab(const QString& text, QWidget* parent) : Painted(parent) {
    setText(text);
    setAccessibleName(text);
    setCheckable(true);
    setAutoExclusive(true);
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
    const int words = static_cast<int>(QFontMetricsF(textFont(13, 500)).horizontalAdvance(text));
    whenScaled(this, [this, words] { setFixedSize(scaled({words + 20, 24})); });
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Theme& t = themeOf(*this);
    ScaledPainter p(this);
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

QAction* MainWindow::addAction(QMenu* menu, const QString& text, const QString& tip, const QKeySequence& key) {
  auto* action = new QAction(text, this);
  action->setToolTip(tip);
  action->setShortcut(key);
  if (menu) menu->addAction(action);
  QMainWindow::addAction(action);
  if (!key.isEmpty()) shortcuts_.push_back(action);
  connect(action, &QAction::triggered, this, [action] { noteCommand(action->text().remove('&').toStdString()); });
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
  run_.back = addAction(nullptr, tr("Look &back"), tr("A frame back in what was shown; with Shift a second"), {});
  run_.back->setShortcuts({Qt::Key_Left, QKeySequence(Qt::SHIFT | Qt::Key_Left)});
  run_.live = addAction(nullptr, tr("Back to &live"), tr("Leave the replay and show what happens now"), Qt::Key_Escape);
  shortcuts_.push_back(run_.back);
  connect(run_.back, &QAction::triggered, this, [this] {
    const bool far = QApplication::keyboardModifiers() & Qt::ShiftModifier;
    session_.looking().lookBack(far ? -60 : -1);
  });
  connect(run_.live, &QAction::triggered, this, [this] {
    if (!live_->leaveFullSize()) session_.looking().backToLive();
  });
  connect(run_.run, &QAction::triggered, this, [this] { session_.life().setRunning(!session_.life().running()); });
  connect(run_.step, &QAction::triggered, &session_.looking(), &Looking::stepOnce);
  connect(run_.restart, &QAction::triggered, this, [this] {
    if (const Status s = session_.newLives().restart(); !s) return messages_->say(toText(s.error().message));
    tellHowItBegan();
  });
  connect(run_.turbo, &QAction::toggled, &session_.life(), &RunningLife::setTurbo);
  liveActions_ = {run_.run, run_.step, run_.restart, run_.turbo, run_.faster, run_.slower, run_.back, run_.live};
  connect(run_.faster, &QAction::triggered, this, [this] { bar_->changePace(+1); });
  connect(run_.slower, &QAction::triggered, this, [this] { bar_->changePace(-1); });
}

void MainWindow::makeFileMenu() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  QMenu* fresh = file->addMenu(tr("&New session in"));
  for (const EnvironmentEntry& entry : session_.life().registry().environments)
    connect(addAction(fresh, fromCore(entry.title), fromCore(entry.help), {}), &QAction::triggered, this,
            [this, name = entry.name] { begin([this, name] { return session_.newLives().beginEnvironment(name); }); });
  const auto item = [&](QMenu* menu, const QString& text, const QString& tip, const QKeySequence& key, auto slot) {
    connect(addAction(menu, text, tip, key), &QAction::triggered, this, slot);
  };
  item(file, tr("&Open …"), tr("Open a session, a Q-function, a journal, a plan or results"), QKeySequence::Open,
       &MainWindow::openWithDialog);
  recent_ = file->addMenu(tr("Open &recent"));
  connect(recent_, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
  addFollowing(file);
  file->addSeparator();
  item(file, tr("&Save"), tr("Save the session: it goes on where it was; on the page Robot, the robot"),
       QKeySequence::Save, [this] { onRobotPage() ? static_cast<void>(robot_->save()) : saveSession(); });
  item(file, tr("Save &as …"), tr("Save the session under another name; on the page Robot, the robot"),
       QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
       [this] { onRobotPage() ? static_cast<void>(robot_->saveAs()) : saveSessionAs(); });
  item(file, tr("Save the Q-&function …"), tr("What was learned, to load it elsewhere"), {},
       [this] { saveWithDialog(SavedAs::QFunction, tr("Save the Q-function"), "learned.safetensors", "safetensors"); });
  item(file, tr("Export the policy as &C …"), tr("The greedy policy as a C99 program that needs nothing else"), {},
       [this] { saveWithDialog(SavedAs::PolicyInC, tr("Export the policy as C"), "policy.c", "c"); });
  item(file, tr("Save the &journal …"), tr("A small text by which the life can be lived again"), {},
       [this] { saveWithDialog(SavedAs::Journal, tr("Save the journal"), "life.jsonl", "jsonl"); });
  QMenu* exporting = file->addMenu(tr("&Export"));
  for (Panel* panel : live_->panels())
    item(exporting, panel->windowTitle() + QStringLiteral(" …"), tr("As PNG, SVG, PDF or CSV"), {},
         [this, panel] { exportWithDialog(panel->view(), panel->windowTitle()); });
  item(exporting, tr("World …"), tr("As PNG, SVG or PDF"), {},
       [this] { exportWithDialog(&live_->world(), tr("World")); });
  item(exporting, tr("The whole window …"), tr("As PNG, SVG or PDF"), {},
       [this] { exportWithDialog(this, tr("Surefoot")); });
  file->addSeparator();
  item(file, tr("&Quit"), tr("Leave the program"), QKeySequence(Qt::CTRL | Qt::Key_Q), &QWidget::close);
}

void MainWindow::makeEditMenu() {
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  undoOfPage_ = new QUndoGroup(this);  // the Live page's; a lesson has its own ways back
  undoOfPage_->addStack(&session_.history().undo());
  undoOfPage_->setActiveStack(&session_.history().undo());
  undo_ = undoOfPage_->createUndoAction(this, tr("&Undo"));
  redo_ = undoOfPage_->createRedoAction(this, tr("&Redo"));
  edit->addActions({undo_, redo_});
  connect(undo_, &QAction::triggered, this, [this] {
    if (onRobotPage()) robot_->undo();
  });
  connect(redo_, &QAction::triggered, this, [this] {
    if (onRobotPage()) robot_->redo();
  });
  connect(undo_, &QAction::triggered, this, [] { noteCommand("Undo"); });
  connect(redo_, &QAction::triggered, this, [] { noteCommand("Redo"); });
  edit->actions()[0]->setShortcut(QKeySequence::Undo);
  edit->actions()[1]->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z));
  edit->actions()[0]->setToolTip(tr("Take the last change back; bring the life before back"));
  edit->actions()[1]->setToolTip(tr("Make the change again"));
  for (QAction* action : edit->actions()) shortcuts_.push_back(action);
  edit->addSeparator();
  connect(addAction(edit, tr("Reset all &parameters"), tr("To what preset and scenario say"), {}), &QAction::triggered,
          live_, &LivePage::resetParameters);
  connect(addAction(edit, tr("Another &seed …"), tr("Begin again with other random numbers"), {}), &QAction::triggered,
          this, &MainWindow::askForSeed);
  edit->addSeparator();
  connect(addAction(edit, tr("Pre&ferences …"), tr("Colours, motion, the start"), QKeySequence::Preferences),
          &QAction::triggered, this, &MainWindow::showPreferences);
}

void MainWindow::makeMenus() {
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();

  QMenu* run = menuBar()->addMenu(tr("&Run"));
  for (QAction* action : {run_.run, run_.step, run_.restart}) run->addAction(action);
  QAction* empty =
      addAction(run, tr("Restart with an &empty table"), tr("Start the life again with the same seed, from nothing"),
                QKeySequence(Qt::SHIFT | Qt::Key_R));
  connect(empty, &QAction::triggered, this, [this] { begin([this] { return session_.newLives().restartEmpty(); }); });
  liveActions_.push_back(empty);
  run->addSeparator();
  for (QAction* action : {run_.turbo, run_.faster, run_.slower}) run->addAction(action);
  run->addSeparator();
  for (QAction* action : {run_.back, run_.live}) run->addAction(action);
  QAction* goOn =
      addAction(run, tr("&Go on from here"),
                tr("The learner's world is put into the moment that a replay shows; it goes on learning"), {});
  connect(goOn, &QAction::triggered, live_, &LivePage::goOn);
  QMenu* whatIf = run->addMenu(tr("&What if"));
  connect(whatIf, &QMenu::aboutToShow, this, [this, whatIf] { fillWhatIf(*whatIf); });
  QAction* compare = addAction(run, tr("&Compare with a second learner"),
                               tr("Another method with the same seed, side by side"), Qt::Key_C);
  compare->setCheckable(true);
  connect(compare, &QAction::toggled, this, [this](bool on) {
    live_->setComparing(on);
    constexpr std::int64_t kHeadStart = 1000;  // [steps]
    if (!on || session_.life().snapshot().steps < kHeadStart) return;
    messages_->ask(tr("The second learner begins now. For a fair race, begin the first again, too?"),
                   {{tr("Begin both again"), [this] { run_.restart->trigger(); }}});
  });
  run->addSeparator();
  QAction* preLearn = addAction(run, tr("&Pre-learn, then transfer …"),
                                tr("Learn in a simulation, then live in reality with what was learned"), Qt::Key_P);
  connect(preLearn, &QAction::triggered, this, &MainWindow::showPreLearning);
  connect(live_, &LivePage::comparingAsked, compare, [this, compare] {
    const QSignalBlocker quiet(compare);
    compare->setChecked(true);
    live_->setComparing(true);
  });
  QAction* rollOut =
      addAction(run, tr("R&oll out 25 s"), tr("What the greedy policy does from a new start, learning nothing"), {});
  connect(rollOut, &QAction::triggered, this, [this] {
    setPage(0);
    live_->rollOut();
  });
  QAction* robustness =
      addAction(run, tr("Rob&ustness …"), tr("How often what was learned falls, over pushes and models"), {});
  connect(robustness, &QAction::triggered, this, &MainWindow::showRobustness);
  for (QAction* action : {compare, preLearn, robustness}) liveActions_.push_back(action);

  QMenu* experiment = menuBar()->addMenu(tr("E&xperiment"));
  const auto item = [&](const QString& text, const QString& tip, void (ExperimentPage::*slot)()) {
    QAction* action = addAction(experiment, text, tip, {});
    connect(action, &QAction::triggered, this, [this] { setPage(1); });
    connect(action, &QAction::triggered, experiment_, slot);
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
  item(tr("Export all lives for a &spreadsheet …"), tr("The same, as Excel reads it"),
       &ExperimentPage::exportForSpreadsheets);
  item(tr("Export all c&harts …"), tr("PNG, PDF and CSV"), &ExperimentPage::exportCharts);

  makeHelpMenu();
  menuBar()->setCornerWidget(makeTabs());
}

QWidget* MainWindow::makeTabs() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 2, 0);
  row->setSpacing(0);
  name_ = new SessionName(box);
  row->addWidget(name_);
  for (const QString& title : {tr("Live"), tr("Experiment"), tr("Lessons"), tr("Robot")}) {
    auto* tab = new PageTab(title, box);
    const int page = static_cast<int>(tabs_.size());
    connect(tab, &QAbstractButton::clicked, this, [this, page] { setPage(page); });
    row->addWidget(tab);
    tabs_.push_back(tab);
  }
  tabs_.front()->setChecked(true);
  return box;
}

/// One thing is different from the moment that a replay shows: how the second acts, or how it learns.
void MainWindow::fillWhatIf(QMenu& menu) {
  menu.clear();
  const Names& now = session_.life().configuration().names;
  const auto add = [&](const QString& text, const std::string& agent, const std::string& policy) {
    connect(menu.addAction(text), &QAction::triggered, live_, [this, agent, policy] { live_->whatIf(agent, policy); });
  };
  add(tr("&Nothing else: the same again"), now.agent, now.policy);
  menu.addSection(tr("Another policy"));
  for (const auto& entry : session_.life().registry().policies)
    if (entry.name != now.policy) add(plainSymbols(fromCore(entry.title)), now.agent, entry.name);
  menu.addSection(tr("Another learning rule"));
  for (const auto& entry : session_.life().registry().agents)
    if (entry.name != now.agent) add(plainSymbols(fromCore(entry.title)), entry.name, now.policy);
}

}  // namespace surefoot
