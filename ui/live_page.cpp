// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live_page.h"

#include <QAction>
#include <QPainter>
#include <QProxyStyle>
#include <QSplitter>
#include <QStyleOption>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/action_rows.h"
#include "ui/falls_list.h"
#include "ui/learning_charts.h"
#include "ui/link_button.h"
#include "ui/map_bar.h"
#include "ui/panel.h"
#include "ui/parameter_form.h"
#include "ui/rival.h"
#include "ui/scrubber.h"
#include "ui/session.h"
#include "ui/step_view.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"
#include "ui/value_maps.h"
#include "ui/world_view.h"

namespace surefoot {

namespace {

/// Separators between docks: wide enough to take hold of, one hairline to see.
class HairlineStyle final : public QProxyStyle {
 public:
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    if (metric == PM_DockWidgetSeparatorExtent) return 5;
    if (metric == PM_DockWidgetFrameWidth) return 0;
    return QProxyStyle::pixelMetric(metric, option, widget);
  }
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    if (element != PE_IndicatorDockWidgetResizeHandle || !widget)
      return QProxyStyle::drawPrimitive(element, option, painter, widget);
    const Theme& t = themeOf(*widget);
    const QRect r = option->rect;
    painter->fillRect(r, t.panel);
    const bool upright = r.height() > r.width();
    painter->fillRect(
        upright ? QRect(r.center().x(), r.top(), 1, r.height()) : QRect(r.left(), r.center().y(), r.width(), 1),
        t.hairline);
  }
};

}  // namespace

LivePage::LivePage(Session& session, QWidget* parent) : QMainWindow(parent), session_(session) {
  setWindowFlags(Qt::Widget);
  auto* style = new HairlineStyle;
  style->setParent(this);
  setStyle(style);
  setDockOptions(AllowNestedDocks | AllowTabbedDocks);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  setCentralWidget(makeCentre());

  form_ = new ParameterForm(session_);
  Panel* parameters = addPanel(tr("Parameters"), "parameters", form_, Qt::LeftDockWidgetArea);
  if (const std::string& preset = session_.configuration().names.preset; !preset.empty())
    parameters->header().setNote(tr("preset %1").arg(toText(preset)));
  auto* links = new QWidget;
  auto* row = new QHBoxLayout(links);
  row->setContentsMargins(0, 0, 4, 0);
  row->setSpacing(2);
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
      addPanel(tr("What the robot would do now"), "actions", new ActionRows(session_), Qt::BottomDockWidgetArea);
  makeMaps();
  makeCharts();

  steps_ = addPanel(tr("This step"), "step", new StepView(session_), Qt::BottomDockWidgetArea);
  steps_->header().setNote(tr("what the last one taught"));
  rule_ = addPanel(tr("Rule of thumb"), "rule", new RuleView(session_), Qt::BottomDockWidgetArea);
  rule_->header().setNote(tr("TRL's threshold"));
  list_ = addPanel(tr("List of falls"), "list", new FallsList(session_), Qt::RightDockWidgetArea);
  list_->header().setNote(tr("a click shows one again"));
  connect(&session_, &Session::frame, this, [this, actions] {
    actions->header().setNote(actionsNote());
    worldHeader_->setNote(worldNote());
  });
}

void LivePage::makeCharts() {
  auto* average = new LearningChart(session_, LearningChart::Shows::AverageReward);
  auto* cumulative = new LearningChart(session_, LearningChart::Shows::Falls);
  average->setBelow(cumulative);
  Panel* reward = addPanel(tr("Average reward"), "reward", average, Qt::RightDockWidgetArea);
  reward->header().setNote(tr("last 80 episodes"));
  Panel* falls = addPanel(tr("Falls"), "falls", cumulative, Qt::RightDockWidgetArea);
  falls->header().setNote(tr("cumulative; each mark is one, click it to replay"));
  auto* range = new LinkButton(tr("Whole life"));
  range->setToolTip(tr("Show the whole life, or only as far as it learned"));
  range->setCheckable(true);
  reward->header().addWidget(range);
  connect(range, &QToolButton::toggled, this, [range, average, cumulative, header = &reward->header()](bool only) {
    range->setText(only ? tr("While it learned") : tr("Whole life"));
    header->layOutExtra();
    average->setLearningOnly(only);
    cumulative->setLearningOnly(only);
  });
}

void LivePage::makeMaps() {
  auto* maps = new ValueMaps(session_);
  Panel* panel = addPanel(tr("Value maps"), "maps", maps, Qt::RightDockWidgetArea);
  auto* bar = new MapBar;
  panel->header().addWidget(bar);
  connect(maps, &ValueMaps::placeAsked, this, [this](const std::vector<double>& state) {
    if (const Status s = session_.place(state); !s) Q_EMIT refused(toText(s.error().message));
  });
  connect(bar, &MapBar::chosen, maps, &ValueMaps::setChoice);
  const auto show = [this, maps, bar] { bar->show(maps->choice(), session_.task(), session_.shown().state); };
  connect(maps, &ValueMaps::shown, bar, show);
  connect(&session_, &Session::lifeReplaced, bar, show);
  if (session_.task().state.size() >= 2) show();
}

QString LivePage::actionsNote() const {
  if (session_.pinned()) return tr("in the state fixed on the map; Escape on the map lets go");
  if (!session_.examined().empty()) return tr("in the state under the cursor on the map");
  return session_.turbo() && session_.running() ? tr("in the state of the real-time world; its next action is marked")
                                                : tr("in the live state; its next action is marked");
}

void LivePage::resetParameters() {
  form_->resetAll();
}

QString LivePage::worldNote() const {
  if (const Playback* p = session_.playback())
    return p->rate > 0 ? tr("%1, at half speed; Escape: back to live").arg(p->title)
                       : tr("%1; ← → move, Escape: back to live").arg(p->title);
  if (session_.runFinished()) return tr("the life is complete");
  if (!session_.running())
    return session_.turbo() ? tr("the learner's own, paused; turbo is on") : tr("the learner's own, paused");
  const QString speed = session_.factorText();
  if (session_.turbo() && world_->held()) return tr("real time; only this world is held, the learner's own is not");
  if (session_.turbo())
    return speed.isEmpty() ? tr("real time, newest Q-function")
                           : tr("real time, newest Q-function; the learner runs %1").arg(speed);
  return speed.isEmpty() ? tr("the learner's own") : tr("the learner's own, %1").arg(speed);
}

QWidget* LivePage::makeCentre() {
  auto* centre = new QWidget;
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  worldHeader_ = new PanelHeader(tr("World"), true, centre);
  worldHeader_->setOnPaper(true);
  world_ = new WorldView(session_, centre);
  column->addWidget(worldHeader_);
  worlds_ = new QSplitter(Qt::Horizontal);
  worlds_->setHandleWidth(1);
  worlds_->setChildrenCollapsible(false);
  worlds_->addWidget(world_);
  column->addWidget(worlds_, 1);
  column->addWidget(new Scrubber(session_, centre));
  connect(worldHeader_, &PanelHeader::fullSizeAsked, this, [this] { toggleFull(centralWidget()); });
  return centre;
}

Panel* LivePage::addPanel(const QString& title, const QString& name, QWidget* content, Qt::DockWidgetArea area) {
  auto* panel = new Panel(title, name, content, content != form_, this);
  addDockWidget(area, panel);
  panels_.push_back(panel);
  connect(panel->toggleViewAction(), &QAction::triggered, panel, [panel](bool on) {
    if (on) panel->raise();
  });
  connect(&panel->header(), &PanelHeader::fullSizeAsked, this, [this, panel] { toggleFull(panel); });
  return panel;
}

// Not by saveState() and restoreState(): they break while a dock is on its way.
void LivePage::toggleFull(QWidget* panel) {
  const bool back = full_ != nullptr;
  if (back) {
    centralWidget()->show();
    QList<QDockWidget*> docks;
    QList<int> widths, heights;
    for (const auto& [shown, size] : before_) {
      shown->show();
      docks << shown, widths << size.width(), heights << size.height();
    }
    resizeDocks(docks, widths, Qt::Horizontal);
    resizeDocks(docks, heights, Qt::Vertical);
  } else {
    before_.clear();
    for (Panel* other : panels_) {
      if (other->isVisible()) before_.emplace_back(other, other->size());
      other->setVisible(other == panel);
    }
    centralWidget()->setVisible(panel == centralWidget());
  }
  full_ = back ? nullptr : panel;
  worldHeader_->setFull(full_ == centralWidget());
  for (Panel* p : panels_) p->header().setFull(full_ == p);
}

void LivePage::setComparing(bool comparing) {
  if (comparing == (rival_ != nullptr)) return;
  if (comparing) {
    rival_ = new Rival(session_);
    connect(rival_, &Rival::refused, this, &LivePage::refused);
    worlds_->addWidget(rival_);
    worlds_->setSizes({1, 1});
  } else {
    delete rival_;
    rival_ = nullptr;
  }
}

// Named layouts: the usual one, one that explains, one of maps.
void LivePage::useLayout(Layout layout) {
  resetLayout();
  const auto panel = [this](const char* name) { return findChild<Panel*>(QLatin1String(name)); };
  switch (layout) {
    case Layout::Usual:
      return;
    case Layout::Teaching:
      for (const char* name : {"parameters", "reward"}) panel(name)->hide();
      for (Panel* p : {steps_, rule_}) p->show();
      addDockWidget(Qt::BottomDockWidgetArea, steps_);
      splitDockWidget(panel("actions"), steps_, Qt::Vertical);
      addDockWidget(Qt::RightDockWidgetArea, rule_);
      resizeDocks({panel("maps")}, {440}, Qt::Horizontal);
      break;
    case Layout::Falls:
      panel("parameters")->hide();
      list_->show();
      break;
    case Layout::Maps:
      for (const char* name : {"parameters", "reward", "falls"}) panel(name)->hide();
      resizeDocks({panel("maps")}, {width() * 6 / 10}, Qt::Horizontal);
      break;
  }
  untouched_ = false;
}

void LivePage::resetLayout() {
  if (full_) toggleFull(full_);
  const auto panel = [this](const char* name) { return findChild<Panel*>(QLatin1String(name)); };
  for (Panel* p : panels_) {
    p->setFloating(false);
    p->show();
  }
  addDockWidget(Qt::LeftDockWidgetArea, panel("parameters"));
  addDockWidget(Qt::BottomDockWidgetArea, panel("actions"));
  addDockWidget(Qt::RightDockWidgetArea, panel("maps"));
  addDockWidget(Qt::RightDockWidgetArea, panel("reward"));
  addDockWidget(Qt::RightDockWidgetArea, panel("falls"));
  addDockWidget(Qt::BottomDockWidgetArea, panel("step"));
  addDockWidget(Qt::BottomDockWidgetArea, panel("rule"));
  addDockWidget(Qt::RightDockWidgetArea, panel("list"));
  // Those that are not shown at first share the place of one that is, or they would cut each other.
  for (Panel* extra : {steps_, rule_}) tabifyDockWidget(panel("actions"), extra);
  tabifyDockWidget(panel("falls"), list_);
  for (Panel* extra : {steps_, rule_, list_}) extra->hide();
  for (const char* front : {"actions", "falls"}) panel(front)->raise();
  untouched_ = true;
  shareSpace();
}

void LivePage::shareSpace() {
  // The columns of the 1280 px window are 264, 576 and 440; a wider one gives most to the middle.
  const auto panel = [this](const char* name) { return findChild<Panel*>(QLatin1String(name)); };
  const bool wide = width() >= 1800;
  resizeDocks({panel("parameters"), panel("maps")}, {wide ? 288 : 264, wide ? 632 : 440}, Qt::Horizontal);
  resizeDocks({panel("actions")}, {268}, Qt::Vertical);
  resizeDocks({panel("maps"), panel("reward"), panel("falls")}, {wide ? 440 : 300, wide ? 288 : 196, wide ? 274 : 190},
              Qt::Vertical);
}

QByteArray LivePage::layoutState() {
  if (full_) toggleFull(full_);
  return saveState(kLayoutVersion);
}

bool LivePage::restoreLayout(const QByteArray& state) {
  laidOut_ = restoreState(state, kLayoutVersion);
  untouched_ = !laidOut_;
  return laidOut_;
}

void LivePage::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  if (laidOut_ && untouched_ && !full_) shareSpace();
}

// What reaches the page itself and none of its panels is a separator.
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
  tabs->setDrawBase(false);
  tabs->setExpanding(false);
}

void LivePage::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (!laidOut_) resetLayout();
  laidOut_ = true;
}

}  // namespace surefoot
