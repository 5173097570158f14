// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment_page.h"

#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "core/text.h"
#include "ui/bar_button.h"
#include "ui/combo.h"
#include "ui/condition_list.h"
#include "ui/experiment_progress.h"
#include "ui/figure_panel.h"
#include "ui/findings_table.h"
#include "ui/link_button.h"
#include "ui/panel.h"
#include "ui/plan_editor.h"
#include "ui/session.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

ExperimentPage::ExperimentPage(Session& session, std::vector<PlanSource> sources, const QString& folder,
                               QWidget* parent)
    : QWidget(parent),
      session_(session),
      experiment_(session.registry(), std::move(sources), folder) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeBar());
  auto* line = new QWidget;
  line->setFixedHeight(1);
  line->setAutoFillBackground(true);
  line->setBackgroundRole(QPalette::Midlight);
  column->addWidget(line);
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
  column->addWidget(splitter, 1);

  connect(editor_, &PlanEditor::used, this, [this] { showPlan(false); });
  connect(editor_, &PlanEditor::liveConditionAsked, this, [this] {
    const auto defaults = configure(session_.registry(), session_.configuration().names, {});
    if (defaults) editor_->addCondition(conditionToml(session_.configuration(), *defaults));
  });
  connect(&experiment_, &Experiment::failed, this, &ExperimentPage::refused);
  connect(&experiment_, &Experiment::leftBehind, this, [this](const QString& store) {
    Q_EMIT refused(tr("What was lived so far is kept; it can be opened again: %1").arg(store));
  });
  for (auto signal :
       {&Experiment::stateChanged, &Experiment::planChanged, &Experiment::progressed, &Experiment::resultsChanged})
    connect(&experiment_, signal, this, &ExperimentPage::refresh);
  if (!experiment_.sources().empty()) choose(0);
  refresh();
}

QWidget* ExperimentPage::makeBar() {
  auto* bar = new QWidget;
  bar->setFixedHeight(48);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(9, 0, 12, 0);
  row->setSpacing(8);
  run_ = new BarButton(Icon::Run, BarButton::Look::Main, tr("Run the experiment"));
  stop_ = new BarButton(Icon::Restart, BarButton::Look::Quiet, tr("Start again: forget what was lived"));
  connect(run_, &QAbstractButton::clicked, this, &ExperimentPage::runOrPause);
  connect(stop_, &QAbstractButton::clicked, this, &ExperimentPage::startAgain);
  source_ = new Combo(tr("Experiment"));
  source_->setFixedSize(380, 32);
  for (const PlanSource& s : experiment_.sources()) source_->addItem(toText(s.title), toText(s.path));
  source_->addItem(tr("Open a plan or results …"));
  connect(source_, &QComboBox::activated, this, &ExperimentPage::choose);
  auto* csv = new QPushButton(tr("CSV"));
  auto* latex = new QPushButton(tr("LaTeX"));
  csv->setAccessibleName(tr("Copy the table as CSV"));
  latex->setAccessibleName(tr("Copy the table as LaTeX"));
  connect(csv, &QPushButton::clicked, this, &ExperimentPage::copyCsv);
  connect(latex, &QPushButton::clicked, this, &ExperimentPage::copyLatex);
  auto* copy = new QLabel(tr("Copy as"));
  copy->setFont(textFont(11));
  copy->setForegroundRole(QPalette::PlaceholderText);
  auto* progress = new ExperimentProgress(experiment_);
  row->addWidget(run_);
  row->addWidget(stop_);
  row->addSpacing(8);
  row->addWidget(source_);
  row->addSpacing(8);
  row->addWidget(progress);
  row->addStretch(1);
  row->addWidget(copy);
  row->addWidget(csv);
  row->addWidget(latex);
  return bar;
}

QWidget* ExperimentPage::makeColumn() {
  auto* column = new QWidget;
  column->setMinimumWidth(240);
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* header = columnHeader_ = new PanelHeader(tr("Conditions"), false);
  header->setNote(tr("lives done"));
  edit_ = new LinkButton(tr("Edit the plan"));
  connect(edit_, &QToolButton::clicked, this, [this] { showPlan(stack_->currentIndex() == 0); });
  header->addWidget(edit_);
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

QWidget* ExperimentPage::makeResults() {
  auto* upper = new QSplitter(Qt::Horizontal);
  upper->setHandleWidth(1);
  upper->setChildrenCollapsible(false);
  for (const std::size_t first : {0, 1}) {
    figures_.push_back(new FigurePanel(experiment_, first));
    upper->addWidget(figures_.back());
  }
  for (FigurePanel* panel : figures_)
    connect(&panel->header(), &PanelHeader::fullSizeAsked, this, [this, panel] {
      FigurePanel* other = panel == figures_[0] ? figures_[1] : figures_[0];
      other->setVisible(!other->isVisible());
      panel->header().setFull(!other->isVisible());
    });
  auto* lower = new QStackedWidget;
  lower->addWidget(new FindingsTable(experiment_));
  auto* claims = new ClaimsTable(experiment_);
  lower->addWidget(claims);
  auto* whole = new QSplitter(Qt::Vertical);
  whole->setHandleWidth(1);
  whole->setChildrenCollapsible(false);
  whole->addWidget(upper);
  auto* table = new QWidget;
  auto* column = new QVBoxLayout(table);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* header = new PanelHeader(tr("Table"), false);
  header->setNote(tr("falls during learning, against the reference of each condition"));
  auto* other = new LinkButton(tr("The thesis's claims"));
  header->addWidget(other);
  const auto turn = [lower, header, other](int page) {
    lower->setCurrentIndex(page);
    header->setNote(page == 0 ? tr("falls during learning, against the reference of each condition")
                              : tr("what the thesis claims, and what came out here"));
    other->setText(page == 0 ? tr("The thesis's claims") : tr("The conditions"));
    header->layOutExtra();
  };
  connect(other, &QToolButton::clicked, this, [lower, turn] { turn(1 - lower->currentIndex()); });
  const auto offer = [claims, lower, other, header, turn] {
    turn(claims->rowCount() == 0 ? 0 : lower->currentIndex());
    other->setEnabled(claims->rowCount() > 0);
    if (claims->rowCount() == 0) other->setText({});
    header->layOutExtra();
  };
  connect(&experiment_, &Experiment::resultsChanged, claims, offer);
  offer();
  summary_ = new QLabel;
  summary_->setTextFormat(Qt::RichText);  // its names are escaped
  summary_->setContentsMargins(12, 6, 12, 10);
  summary_->setWordWrap(true);
  column->addWidget(header);
  column->addWidget(lower, 1);
  column->addWidget(summary_);
  whole->addWidget(table);
  whole->setSizes({380, 300});
  return whole;
}

void ExperimentPage::choose(int index) {
  if (index == source_->count() - 1) return openWithDialog();
  open(source_->itemData(index).toString());
}

void ExperimentPage::open(const QString& path) {
  if (const Status s = experiment_.open(path.toStdString()); !s) {
    Q_EMIT refused(toText(s.error().message));
    return;
  }
  const int known = source_->findData(path);
  if (known < 0) source_->insertItem(source_->count() - 1, toText(experiment_.title()), path);
  source_->setCurrentIndex(source_->findData(path));
  if (!experiment_.plan()) showPlan(false);
}

void ExperimentPage::showPlan(bool shown) {
  stack_->setCurrentIndex(shown ? 1 : 0);
  edit_->setText(shown ? tr("Show the results") : tr("Edit the plan"));
  columnHeader_->layOutExtra();
  if (shown && editor_->text().isEmpty()) editor_->setText(toText(experiment_.text()));
}

void ExperimentPage::runOrPause() {
  if (experiment_.state() == Experiment::State::Running) return experiment_.pause();
  if (const Status s = experiment_.run(); !s) Q_EMIT refused(toText(s.error().message));
}

void ExperimentPage::startAgain() {
  if (experiment_.plan()) static_cast<void>(static_cast<bool>(experiment_.setText(std::string(experiment_.text()))));
}

QString ExperimentPage::summary() const {
  if (!experiment_.view()) return tr("The finding in one sentence appears here.");
  const bool running = experiment_.state() == Experiment::State::Running;
  const Finding* best = nullptr;
  for (const Finding& f : experiment_.view()->findings.conditions)
    if (f.comparison && f.comparison->significant() && std::isfinite(f.comparison->change.value) &&
        (!best || f.comparison->change.value < best->comparison->change.value))
      best = &f;
  if (!best || best->comparison->change.value >= 0)
    return running ? tr("So far no condition falls significantly less than its reference (p < .01).")
                   : tr("No condition falls significantly less than its reference (p < .01).");
  const Interval& i = best->comparison->change;
  QString text = tr("<b>%1 falls %2 % less than %3</b>")
                     .arg(toText(best->name).toHtmlEscaped(), toText(fixedText(-i.value, 0)),
                          toText(best->reference).toHtmlEscaped());
  text += i.known()
              ? tr(" (95 % interval %1 to %2 %).").arg(toText(fixedText(-i.high, 0)), toText(fixedText(-i.low, 0)))
              : tr(".");
  if (best->betweenQFunctions)
    text +=
        tr(" Q-functions carry %1 % of the variance.").arg(toText(fixedText(100 * best->betweenQFunctions->share, 0)));
  return text;
}

void ExperimentPage::refresh() {
  const bool running = experiment_.state() == Experiment::State::Running;
  auto* run = static_cast<BarButton*>(run_);
  run->setIcon(running ? Icon::Pause : Icon::Run);
  run->setEnabled(running || experiment_.canRun());
  run->setTip(running ? tr("Pause: lives in hand are given up, the others kept") : tr("Run the experiment"));
  stop_->setEnabled(experiment_.plan().has_value() && experiment_.livesDone() > 0);
  edit_->setEnabled(experiment_.plan().has_value());
  summary_->setText(summary());
  const QString left =
      experiment_.storePath().empty()
          ? tr("nothing lived yet")
          : tr("%1, saved after every life").arg(QFileInfo(toText(experiment_.storePath())).fileName());
  Q_EMIT statusChanged(left, tr("%1 falls").arg(toText(countText(static_cast<double>(experiment_.falls())))));
}

}  // namespace surefoot
