// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/experiment_page.h"

#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/controls/bar_button.h"
#include "ui/controls/link_button.h"
#include "ui/controls/notice_strip.h"
#include "ui/controls/panel.h"
#include "ui/experiment/condition_list.h"
#include "ui/experiment/experiment_progress.h"
#include "ui/experiment/figures/condition_name.h"
#include "ui/experiment/plan_editor.h"
#include "ui/experiment/plans/plan_chooser.h"
#include "ui/language/numbers.h"
#include "ui/running/running_life.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/counted.h"

namespace surefoot {

namespace {

/// Where the results are, the person's own folder as ~.
QString storeText(const Experiment& experiment) {
  const Following* followed = experiment.following();
  const std::string& path = followed ? followed->path() : experiment.storePath();
  if (path.empty()) return QObject::tr("nothing lived yet");
  QString shown = toText(path);
  if (shown.startsWith(QDir::homePath() + '/')) shown.replace(0, QDir::homePath().size(), QStringLiteral("~"));
  return followed ? QObject::tr("%1, followed").arg(shown) : QObject::tr("%1, saved after every life").arg(shown);
}

}  // namespace

ExperimentPage::ExperimentPage(const RunningLife& life, std::vector<PlanSource> sources, const QString& folder,
                               QWidget* parent)
    : QWidget(parent),
      life_(life),
      experiment_(life.registry(), std::move(sources), folder) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeBar());
  auto* line = new QWidget;
  line->setFixedHeight(1);
  line->setAutoFillBackground(true);
  line->setBackgroundRole(QPalette::Midlight);
  column->addWidget(line);
  following_ = new NoticeStrip;
  following_->addLink(tr("Stop following"), tr("The results stay, as if the store had been opened"),
                      [this] { stopFollowing(); });
  column->addWidget(following_);
  auto* splitter = new QSplitter(Qt::Horizontal);
  splitter->setHandleWidth(1);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(makeColumn());
  stack_ = new QStackedWidget;
  stack_->addWidget(makeResults());
  editor_ = new PlanEditor(experiment_);
  stack_->addWidget(editor_);
  splitter->addWidget(stack_);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({264, 1016});
  auto* scroll = new QScrollArea;  // on the smallest screens
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(splitter);
  column->addWidget(scroll, 1);

  connect(editor_, &PlanEditor::used, this, [this] { showPlan(false); });
  connect(editor_, &PlanEditor::liveConditionAsked, this, [this] { editor_->addConfiguration(life_.configuration()); });
  connect(&experiment_, &Experiment::failed, this, [this](const QString& why) {
    runWhenOpen_ = false;
    Q_EMIT refused(why);
  });
  connect(&writing_, &Background::failed, this, &ExperimentPage::refused);
  connect(&experiment_, &Experiment::leftBehind, this, [this](const QString& store) {
    const bool complete = experiment_.livesDone() == experiment_.livesPlanned();
    Q_EMIT refused((complete ? tr("The results are kept. They stand in the list of experiments, and here: %1")
                             : tr("What was lived so far is kept and can be gone on with. It stands in the list of "
                                  "experiments, and here: %1"))
                       .arg(store));
    source_->addOwn(tr("%1 (%2 of %3 lives)")
                        .arg(toText(experiment_.title()))
                        .arg(experiment_.livesDone())
                        .arg(experiment_.livesPlanned()),
                    store);
  });
  for (auto signal :
       {&Experiment::stateChanged, &Experiment::planChanged, &Experiment::progressed, &Experiment::resultsChanged})
    connect(&experiment_, signal, this, &ExperimentPage::refresh);
  for (auto signal : {&Experiment::stateChanged, &Experiment::followed})
    connect(&experiment_, signal, this, &ExperimentPage::showFollowing);
  if (!experiment_.sources().empty()) open(toText(experiment_.sources().front().path));
  refresh();
}

QWidget* ExperimentPage::makeBar() {
  auto* bar = new QWidget;
  auto* row = bar_ = new QHBoxLayout(bar);
  run_ = new BarButton(Icon::Run, BarButton::Look::Main, tr("Run the experiment"));
  stop_ = new BarButton(Icon::Restart, BarButton::Look::Quiet, tr("Start again: forget what was lived"));
  connect(run_, &QAbstractButton::clicked, this, &ExperimentPage::runOrPause);
  connect(stop_, &QAbstractButton::clicked, this, &ExperimentPage::startAgain);
  source_ = new PlanChooser(tr("Experiment"), experiment_.sources());
  source_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(source_, &PlanChooser::planChosen, this, &ExperimentPage::open);
  connect(source_, &PlanChooser::openAsked, this, &ExperimentPage::openWithDialog);
  connect(&experiment_, &Experiment::planChanged, this, [this] {
    const bool waits = experiment_.following() && experiment_.storedPlan().conditions.empty();
    if (!experiment_.path().empty() && !waits) source_->addOwn(toText(experiment_.title()), toText(experiment_.path()));
    source_->setCurrent(waits ? experiment_.following()->name() : shownName(experiment_.title()));
    if (experiment_.text().empty()) showPlan(false);
    if (std::exchange(runWhenOpen_, false)) runOrPause();
  });
  askForLives();
  auto* csv = new QPushButton(tr("CSV"));
  auto* latex = new QPushButton(tr("LaTeX"));
  csv->setAccessibleName(tr("Copy the table as CSV"));
  latex->setAccessibleName(tr("Copy the table as LaTeX"));
  connect(csv, &QPushButton::clicked, this, &ExperimentPage::copyCsv);
  connect(latex, &QPushButton::clicked, this, &ExperimentPage::copyLatex);
  auto* copy = new QLabel(tr("Copy as"));
  copy->setForegroundRole(QPalette::PlaceholderText);
  auto* progress = new ExperimentProgress(experiment_);
  row->addWidget(run_);
  row->addWidget(stop_);
  row->addWidget(source_, 12);
  row->addWidget(lives_);
  row->addWidget(progress, 6);
  row->addStretch(1);
  row->addWidget(copy);
  row->addWidget(csv);
  row->addWidget(latex);
  copies_ = {copy, csv, latex};
  whenScaled(bar, [this, bar, row, copy] {
    bar->setFixedHeight(scaled(48));
    row->setContentsMargins(scaled({9, 0, 12, 0}));
    row->setSpacing(scaled(8));
    source_->setFixedHeight(scaled(32));
    source_->setMaximumWidth(scaled(560));
    lives_->setFixedHeight(scaled(32));
    copy->setFont(scaledFont(11));
    foldBar();
  });
  return bar;
}

void ExperimentPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  foldBar();
}

void ExperimentPage::foldBar() {
  const QMargins edges = bar_->contentsMargins();
  int need = edges.left() + edges.right() - bar_->spacing();
  for (int i = 0; i < bar_->count(); ++i)
    if (const QWidget* part = bar_->itemAt(i)->widget())
      need += part->minimumSizeHint().expandedTo(part->minimumSize()).width() + bar_->spacing();
  for (QWidget* copy : copies_) copy->setVisible(need <= width());
}

QWidget* ExperimentPage::makeColumn() {
  auto* column = new QWidget;
  whenScaled(column, [column] { column->setMinimumWidth(scaled(240)); });
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* header = columnHeader_ = new PanelHeader(tr("Conditions"), false);
  header->setNote(tr("lives done"));
  edit_ = new LinkButton(tr("Edit the plan"));
  connect(edit_, &QToolButton::clicked, this, [this] { showPlan(stack_->currentIndex() == 0); });
  header->addWidget(edit_);
  header->setHelp(QStringLiteral("page-experiment"));
  layout->addWidget(header);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(new ConditionList(experiment_));
  layout->addWidget(scroll, 1);
  return column;
}

void ExperimentPage::open(const QString& path) {
  runWhenOpen_ = false;
  if (const Status s = experiment_.open(path.toStdString()); !s) Q_EMIT refused(toText(s.error().message));
}

void ExperimentPage::follow(const QString& path) {
  runWhenOpen_ = false;
  experiment_.follow(path.toStdString());
}

void ExperimentPage::showFollowing() {
  const Following* file = experiment_.following();
  following_->say(file ? tr("Following %1, read only").arg(file->name()) : QString(), experiment_.followingText(),
                  file && file->warns());
}

void ExperimentPage::showPlan(bool shown) {
  stack_->setCurrentIndex(shown ? 1 : 0);
  edit_->setText(shown ? tr("Show the results") : tr("Edit the plan"));
  columnHeader_->layOutExtra();
  if (shown && editor_->text().isEmpty()) editor_->setText(toText(experiment_.text()));
}

void ExperimentPage::runOrPause() {
  if (experiment_.state() == Experiment::State::Running) return experiment_.pause();
  if (experiment_.isOpening()) {
    runWhenOpen_ = true;
    return;
  }
  const Status s = experiment_.run();
  if (s) return;
  const QString why = toText(s.error().message);
  switch (experiment_.needs()) {
    case Experiment::Consent::None:
      return Q_EMIT refused(why);
    case Experiment::Consent::OtherVersion:
      return Q_EMIT asked(why, tr("Go on all the same"), [this] {
        if (const Status again = experiment_.run(true); !again) Q_EMIT refused(toText(again.error().message));
      });
    case Experiment::Consent::Programs:
      return Q_EMIT asked(why, tr("Allow it, and go on"), [this] {
        experiment_.allowProgram();
        runOrPause();
      });
  }
}

void ExperimentPage::startAgain() {
  if (experiment_.canStartAgain())
    static_cast<void>(static_cast<bool>(experiment_.setText(std::string(experiment_.text()))));
}

void ExperimentPage::refresh() {
  const bool running = experiment_.state() == Experiment::State::Running;
  auto* run = static_cast<BarButton*>(run_);
  run->setIcon(running ? Icon::Pause : Icon::Run);
  run->setEnabled(running || (experiment_.canRun() && !experiment_.isOpening()));
  run->setTip(running ? tr("Pause: lives stand still where they are") : tr("Run the experiment"));
  stop_->setEnabled(experiment_.canStartAgain() && !experiment_.isOpening());
  edit_->setEnabled(!experiment_.text().empty());
  summary_->setText(summaryOf(experiment_));
  showLives();
  const auto count = [](std::int64_t n) { return countNumber(static_cast<double>(n)); };
  QString right = tr("%1 in %2").arg(fallsText(experiment_.fallsShown()), livesText(experiment_.livesShown()));
  if (const std::int64_t more = experiment_.falls() - experiment_.fallsShown();
      more > 0 && experiment_.state() != Experiment::State::Complete)
    right += tr(", and %1 in lives that are not over").arg(count(more));
  Q_EMIT statusChanged(storeText(experiment_), right);
}

}  // namespace surefoot

#include "moc_experiment_page.cpp"
