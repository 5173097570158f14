// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/live_page.h"

#include <QAction>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/controls/link_button.h"
#include "ui/controls/panel.h"
#include "ui/controls/view_menu.h"
#include "ui/language/numbers.h"
#include "ui/live/actions/action_key.h"
#include "ui/live/actions/action_rows.h"
#include "ui/live/charts/chart_span.h"
#include "ui/live/charts/learning_charts.h"
#include "ui/live/compare_strip.h"
#include "ui/live/falls_list.h"
#include "ui/live/form/parameter_form.h"
#include "ui/live/maps/map_bar.h"
#include "ui/live/maps/value_maps.h"
#include "ui/live/rival.h"
#include "ui/live/rule_view.h"
#include "ui/live/step_view.h"
#include "ui/live/world/scrubber.h"
#include "ui/live/world/world_view.h"
#include "ui/live/worlds.h"
#include "ui/session/session.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/support/counted.h"
#include "ui/support/help.h"

namespace surefoot {

LivePage::LivePage(Session& session, QWidget* parent) : QMainWindow(parent), session_(session) {
  setWindowFlags(Qt::Widget);
  setDockOptions(AllowNestedDocks | AllowTabbedDocks);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  setCentralWidget(makeCentre());

  form_ = new ParameterForm(session_.life(), session_.editing(), session_.history());
  Panel* parameters = addPanel(tr("Parameters"), "parameters", form_, Qt::LeftDockWidgetArea);
  if (const std::string& preset = session_.life().configuration().names.preset; !preset.empty())
    parameters->header().setNote(tr("preset %1").arg(toText(preset)));
  auto* links = new QWidget;
  auto* row = new QHBoxLayout(links);
  whenScaled(links, [row] {
    row->setContentsMargins(scaled({0, 0, 4, 0}));
    row->setSpacing(scaled(2));
  });
  QToolButton *all = new LinkButton(tr("More")), *reset = new LinkButton(tr("Reset all"));
  row->addWidget(all);
  row->addWidget(reset);
  parameters->header().addWidget(links);
  connect(all, &QToolButton::clicked, this, [this, all, parameters] {
    form_->setShowAll(!form_->showsAll());
    all->setText(form_->showsAll() ? tr("Fewer") : tr("More"));
  });
  connect(reset, &QToolButton::clicked, form_, &ParameterForm::resetAll);
  connect(form_, &ParameterForm::refused, this, &LivePage::refused);

  Panel* actions =
      addPanel(tr("What the robot would do now"), "actions",
               new ActionRows(session_.life(), session_.looking(), session_.editing()), Qt::BottomDockWidgetArea);
  actions->header().addWidget(new ActionKey(session_.life(), session_.looking()));
  makeMaps();
  makeCharts();
  makeWords();
  makeSignals();
  sizedFor_ = textSize();
  whenScaled(this, [this] { followTextSize(); });
  const auto note = [this, actions] {
    actions->header().setNote(actionsNote());
    worldHeader_->setNote(worldNote());
  };
  connect(&session_.looking(), &Looking::frame, this, note);
  connect(&session_.life(), &RunningLife::stateChanged, this, note);
}

void LivePage::makeWords() {
  steps_ =
      addPanel(tr("This step"), "step", new StepView(session_.life(), session_.looking()), Qt::BottomDockWidgetArea);
  steps_->header().setNote(tr("what the last one taught"));
  rule_ = addPanel(tr("Rule of thumb"), "rule", new RuleView(session_.life(), session_.editing()),
                   Qt::BottomDockWidgetArea);
  rule_->header().setNote(tr("TRL's threshold"));
  list_ = addPanel(tr("List of falls"), "list", new FallsList(session_.life(), session_.looking()),
                   Qt::RightDockWidgetArea);
  list_->header().setNote(tr("a click shows one again"));
}

void LivePage::makeCharts() {
  auto* span = new ChartSpan(session_.life(), this);
  auto* average = new LearningChart(session_.life(), session_.looking(), session_.history(), *span,
                                    LearningChart::Shows::AverageReward);
  auto* cumulative =
      new LearningChart(session_.life(), session_.looking(), session_.history(), *span, LearningChart::Shows::Falls);
  average->setBelow(cumulative);
  Panel* reward = addPanel(tr("Average reward"), "reward", average, Qt::RightDockWidgetArea);
  const auto noteReward = [this, reward] {
    const std::int64_t episodes = session_.life().numbers().episodes;
    reward->header().setNote(episodes == 0 || episodes >= EpisodeLog::kAverageOver
                                 ? tr("last %1 episodes").arg(EpisodeLog::kAverageOver)
                                 : tr("all %1 so far").arg(episodesText(episodes)));
  };
  noteReward();
  for (const auto changed : {&RunningLife::replaced, &RunningLife::valuesArrived})
    connect(&session_.life(), changed, this, noteReward);
  connect(&session_.life(), &RunningLife::parametersReplaced, this, &LivePage::followTask);
  Panel* falls = addPanel(tr("Falls"), "falls", cumulative, Qt::RightDockWidgetArea);
  const auto noteFalls = [this, span, falls] { falls->header().setNote(fallsNote(*span)); };
  connect(span, &ChartSpan::changed, this, noteFalls);
  connect(&session_.life(), &RunningLife::valuesArrived, this, noteFalls);
  noteFalls();
  auto* range = new LinkButton(tr("Whole life"));
  range->setToolTip(
      tr("Show the whole life, or only as far as it learned. In the chart the wheel or a drag magnifies "
         "a part; a double click or Home shows the whole life."));
  reward->header().addWidget(range);
  const auto say = [range, span, header = &reward->header()] {
    const ChartSpan::Shows shows = span->shows();
    range->setText(shows == ChartSpan::Shows::Part       ? tr("A part")
                   : shows == ChartSpan::Shows::Learning ? tr("While it learned")
                                                         : tr("Whole life"));
    range->setAccessibleName(tr("Time shown: %1").arg(range->text()));
    header->layOutExtra();
  };
  connect(span, &ChartSpan::changed, this, say);
  connect(range, &QToolButton::clicked, this,
          [span] { span->shows() == ChartSpan::Shows::WholeLife ? span->showLearning() : span->showWholeLife(); });
}

/// The numbers at the curves belong to the end of the shown part; the note says so if this is not the life's end.
QString LivePage::fallsNote(const ChartSpan& span) const {
  const bool all = span.timeOf(session_.life().latest()) <= span.to();
  const QString end = countNumber(span.to());
  const QString counted = all                ? tr("cumulative")
                          : span.inMinutes() ? tr("up to minute %1").arg(end)
                                             : tr("up to episode %1").arg(end);
  const std::int64_t byHand = session_.life().numbers().fallsByHand;
  const QString hands = countNumber(static_cast<double>(byHand));
  return byHand > 0 ? tr("%1; %2 after a push or placing by hand").arg(counted, hands)
                    : tr("%1; click a mark to replay it").arg(counted);
}

void LivePage::makeMaps() {
  auto* maps = new ValueMaps(session_.life(), session_.looking());
  Panel* panel = addPanel(tr("Value maps"), "maps", maps, Qt::RightDockWidgetArea);
  auto* bar = new MapBar;
  panel->header().addWidget(bar);
  connect(maps, &ValueMaps::placeAsked, this, [this](const std::vector<double>& state) {
    if (const Status s = session_.life().place(state); !s) Q_EMIT refused(toText(s.error().message));
  });
  connect(bar, &MapBar::chosen, maps, &ValueMaps::setChoice);
  const auto show = [this, maps, bar] {
    bar->show(maps->choice(), session_.life().task(), session_.looking().shown().state,
              !session_.looking().shown().risk.empty());
  };
  connect(maps, &ValueMaps::shown, bar, show);
  connect(&session_.life(), &RunningLife::replaced, bar, show);
  if (!session_.life().task().state.empty()) show();
}

QString LivePage::actionsNote() const {
  if (session_.looking().pinned()) return tr("in the state fixed on the map; Escape on the map lets go");
  if (!session_.looking().examined().empty()) return tr("in the state under the cursor on the map");
  if (!session_.life().task().actionVariables.empty())
    return tr("the next action is shaded; %1 actions, by joint").arg(session_.life().task().actions.size());
  if (session_.looking().playback()) return tr("in the replay");
  const bool other = session_.looking().hasViewer();  // another world than the learner's
  return session_.life().turbo() && session_.life().running() && other ? tr("in the real-time world")
                                                                       : tr("the next action is shaded");
}

void LivePage::resetParameters() {
  form_->resetAll();
}

QString LivePage::worldNote() const {
  if (const Playback* p = session_.looking().playback())
    return p->rate > 0 ? tr("%1; Escape: back to live").arg(p->title)
                       : tr("%1; ← → move, Escape: back to live").arg(p->title);
  if (session_.looking().demonstrating() && !session_.life().running() && session_.looking().hasViewer())
    return tr("real time, newest Q-function; nothing is learned");
  if (session_.life().finished()) return tr("the life is complete");
  if (!session_.life().running())
    return session_.life().turbo() ? tr("the learner's world, paused; turbo is on") : tr("the learner's world, paused");
  const QString beginning = session_.life().beginning();
  if (!beginning.isEmpty() && !session_.life().turbo())
    return tr("the learner's world; its life began %1").arg(beginning);
  const QString speed = session_.life().factorText();
  if (!session_.looking().hasViewer())
    return speed.isEmpty() ? tr("the learner's world") : tr("the learner's world, %1").arg(speed);
  if (session_.life().turbo() && world_->held()) return tr("real time; only this world is held, the learner's is not");
  if (session_.life().turbo())
    return speed.isEmpty() ? tr("real time, newest Q-function")
                           : tr("real time, newest Q-function; the learner runs %1").arg(speed);
  return speed.isEmpty() ? tr("the learner's world") : tr("the learner's world, %1").arg(speed);
}

QWidget* LivePage::makeCentre() {
  auto* centre = new QWidget;
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  worldHeader_ = new PanelHeader(tr("World"), true, centre);
  worldHeader_->setOnPaper(true);
  worldHeader_->setHelp(QStringLiteral("panel-world"));
  setHelpPage(*centre, QStringLiteral("panel-world"));
  auto* scrubber = new Scrubber(session_.looking());
  worldHeader_->addWidget(scrubber);
  connect(scrubber, &Scrubber::goOnAsked, this, &LivePage::goOn);
  world_ = new WorldView(session_.life(), session_.looking(), centre);
  new ViewMenu(*world_);
  column->addWidget(worldHeader_);
  worlds_ = new Worlds;
  worlds_->addWidget(world_);
  column->addWidget(worlds_, 1);
  connect(worldHeader_, &PanelHeader::fullSizeAsked, this, [this] { toggleFull(centralWidget()); });
  return centre;
}

Panel* LivePage::addPanel(const QString& title, const QString& name, QWidget* content, Qt::DockWidgetArea area) {
  auto* panel = new Panel(title, name, content, content != form_, this);
  addDockWidget(area, panel);
  panels_.push_back(panel);
  if (content != form_) new ViewMenu(*panel->view());
  connect(panel->toggleViewAction(), &QAction::triggered, panel, [this, panel](bool on) {
    if (on) panel->raise();
    if (!on) keepFocus();
  });
  connect(&panel->header(), &PanelHeader::fullSizeAsked, this, [this, panel] { toggleFull(panel); });
  return panel;
}

void LivePage::setComparing(bool comparing) {
  if (comparing == (rival_ != nullptr)) return;
  if (comparing && !resting_) makeRival();
  std::swap(rival_, resting_);
  Rival& second = rival_ ? *rival_ : *resting_;
  second.setVisible(comparing);
  second.strip().setVisible(comparing);
  if (comparing) worlds_->setSizes({1, 1});
  second.setResting(!comparing);
  world_->setBeside(rival_ ? &rival_->world() : nullptr, tr("First"));
  second.world().setBeside(rival_ ? world_ : nullptr, tr("Second"));
  for (LearningChart* chart : findChildren<LearningChart*>())
    chart->setSecond(rival_ ? &rival_->session().life() : nullptr);
  showSignalsOfSecond();
}

void LivePage::makeRival() {
  resting_ = new Rival(session_.life());
  connect(resting_, &Rival::refused, this, &LivePage::refused);
  connect(resting_, &Rival::told, this, &LivePage::told);
  connect(resting_, &Rival::newTableAsked, this, &LivePage::newTableAsked);
  new ViewMenu(resting_->world());
  worlds_->addWidget(resting_);
  if (auto* column = qobject_cast<QVBoxLayout*>(worlds_->parentWidget()->layout()))
    column->insertWidget(column->indexOf(worlds_), &resting_->strip());
}

void LivePage::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  if (laidOut_ && untouched_ && !full_) shareSpace();
}

// A press that reaches the page itself, and no panel, is on a separator.
void LivePage::mousePressEvent(QMouseEvent* event) {
  untouched_ = false;
  QMainWindow::mousePressEvent(event);
}

// The tabs of panels that share a place are made by Qt as they are needed.
void LivePage::childEvent(QChildEvent* event) {
  QMainWindow::childEvent(event);
  auto* tabs = event->polished() ? qobject_cast<QTabBar*>(event->child()) : nullptr;
  if (!tabs) return;
  tabs->setAccessibleName(tr("Panels that share this place"));
  tabs->setExpanding(false);
}

void LivePage::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (!laidOut_) resetLayout();
  laidOut_ = true;
}

}  // namespace surefoot

#include "moc_live_page.cpp"
