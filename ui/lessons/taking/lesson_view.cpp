// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/lesson_view.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "core/text/text.h"
#include "ui/controls/bar_button.h"
#include "ui/controls/hairline.h"
#include "ui/controls/link_button.h"
#include "ui/controls/slider.h"
#include "ui/lessons/taking/lesson_column.h"
#include "ui/lessons/taking/lesson_panels.h"
#include "ui/lessons/taking/prediction_box.h"
#include "ui/live/run_bar.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

LessonView::LessonView(const Registry& registry, Lesson lesson, HandIn handIn, QWidget* parent)
    : QWidget(parent),
      driver_(std::make_unique<LessonDriver>(registry, std::move(lesson), std::move(handIn))) {
  makeActions();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeBar());
  column->addWidget(new Hairline(Qt::Horizontal, this));
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  column_ = new LessonColumn(*driver_, this);
  panels_ = new LessonPanels(*driver_, this);
  row->addWidget(column_);
  row->addWidget(new Hairline(Qt::Vertical, this));
  row->addWidget(panels_, 1);
  column->addLayout(row, 1);
  whenScaled(this, [this] { column_->setFixedWidth(std::min(scaled(320), static_cast<int>(kMostColumn * width()))); });
  panels_->setRunWords([this](const RunCurve& curve) {
    const auto found = runWords_.find(curve.number);
    return found == runWords_.end() ? QString() : found->second;
  });
  connect(driver_.get(), &LessonDriver::refused, this, &LessonView::refused);
  connect(column_, &LessonColumn::refused, this, &LessonView::refused);
  connect(panels_, &LessonPanels::refused, this, &LessonView::refused);
  connect(column_, &LessonColumn::exploreAsked, this, &LessonView::exploreAsked);
  connect(column_, &LessonColumn::lessonAsked, this, &LessonView::lessonAsked);
  connect(column_, &LessonColumn::nextLessonAsked, this, &LessonView::allLessonsAsked);
  connect(column_, &LessonColumn::predictionMoved, this, &LessonView::refreshPrediction);
  connect(panels_, &LessonPanels::predictionMoved, this, [this](double value) {
    if (auto* box = qobject_cast<PredictionBox*>(column_->question())) box->setValue(value);
  });
  connect(driver_.get(), &LessonDriver::stepChanged, this, &LessonView::refreshPrediction);
  connect(driver_.get(), &LessonDriver::phaseChanged, this, &LessonView::refreshPrediction);
  connect(driver_.get(), &LessonDriver::stepChanged, this, &LessonView::refresh);
  connect(driver_.get(), &LessonDriver::phaseChanged, this, &LessonView::showLastFall);
  connect(driver_.get(), &LessonDriver::phaseChanged, this, &LessonView::refresh);
  RunningLife& life = driver_->session().life();
  connect(&life, &RunningLife::stateChanged, this, &LessonView::refresh);
  connect(&life, &RunningLife::valuesArrived, this, &LessonView::refresh);
  connect(&life, &RunningLife::replaced, this, &LessonView::refresh);
  connect(&life, &RunningLife::configurationChanged, this, &LessonView::nameRun);
  connect(&driver_->session().looking(), &Looking::fallReplayed, driver_.get(), &LessonDriver::noteReplay);
}

LessonView::~LessonView() {
  // The panels know the session, which belongs to the driver.
  delete panels_;
  delete column_;
}

QAction* LessonView::act(const QString& text, const QList<QKeySequence>& keys, const std::function<void()>& what) {
  auto* action = new QAction(text, this);
  action->setShortcuts(keys);
  // Alt and an arrow go on from wherever the focus is in the window; single keys only within the lesson.
  const bool single = keys.front()[0].keyboardModifiers() == Qt::NoModifier;
  action->setShortcutContext(single ? Qt::WidgetWithChildrenShortcut : Qt::WindowShortcut);
  connect(action, &QAction::triggered, this, what);
  addAction(action);
  return action;
}

void LessonView::makeActions() {
  RunningLife& life = driver_->session().life();
  run_ = act(tr("Run"), {Qt::Key_Space}, [&life] { life.setRunning(!life.running()); });
  restart_ = act(tr("Restart"), {Qt::Key_R}, [this] {
    if (const Status s = driver_->session().newLives().restart(); !s) Q_EMIT refused(toText(s.error().message));
  });
  turbo_ = act(tr("Turbo"), {Qt::Key_T}, [&life] { life.setTurbo(!life.turbo()); });
  turbo_->setCheckable(true);
  run_->setToolTip(tr("Run or pause"));
  restart_->setToolTip(tr("Start the life again with the same seed"));
  turbo_->setToolTip(tr("Learn flat out"));
  act(tr("Next"), {QKeySequence(Qt::ALT | Qt::Key_Right)}, [this] { column_->goOn(); });
  act(tr("Back"), {QKeySequence(Qt::ALT | Qt::Key_Left)}, [this] { column_->goBack(); });
}

QWidget* LessonView::makeBar() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  runButtons_ = {new BarButton(run_, Icon::Run, BarButton::Look::Main, bar),
                 new BarButton(restart_, Icon::Restart, BarButton::Look::Quiet, bar),
                 new BarButton(turbo_, Icon::Turbo, BarButton::Look::Framed, bar)};
  for (QWidget* button : runButtons_) {
    QSizePolicy keeps = button->sizePolicy();
    keeps.setRetainSizeWhenHidden(true);  // so that nothing beside it jumps from step to step
    button->setSizePolicy(keeps);
    row->addWidget(button);
  }
  pace_ = new Slider(bar);
  pace_->setAccessibleName(tr("Pace"));
  pace_->setToolTip(tr("How fast the world runs; real time is in the middle"));
  pace_->setValue(RunBar::positionOfPace(driver_->session().life().pace()));
  connect(pace_, &QSlider::valueChanged, this,
          [this](int at) { driver_->session().life().setPace(RunBar::paceAt(at)); });
  paceWord_ = new QLabel(tr("Pace"), bar);
  paceWord_->setForegroundRole(QPalette::PlaceholderText);
  whenScaled(pace_, [this] {
    pace_->setFixedWidth(scaled(96));
    paceWord_->setFont(scaledFont(11));
  });
  auto* all = new LinkButton(tr("‹  All lessons"), bar);
  all->setToolTip(tr("The list of lessons; this one waits at its step"));
  connect(all, &QToolButton::clicked, this, &LessonView::allLessonsAsked);
  row->addWidget(all);
  row->addWidget(paceWord_);
  row->addWidget(pace_);
  auto* teacher = new LinkButton(tr("Teacher"), bar);
  teacher->setToolTip(tr("Notes, answers and the class, in a window for the teacher's own screen"));
  connect(teacher, &QToolButton::clicked, this, &LessonView::teacherAsked);
  row->addWidget(teacher);
  row->addStretch(1);
  falls_ = new QLabel(bar);
  episodes_ = new QLabel(bar);
  auto* fallsWord = new QLabel(tr("falls"), bar);
  auto* episodesWord = new QLabel(tr("episodes"), bar);
  for (QLabel* label : {falls_, fallsWord, episodes_, episodesWord}) row->addWidget(label);
  for (QLabel* label : {fallsWord, episodesWord}) label->setForegroundRole(QPalette::PlaceholderText);
  whenScaled(bar, [this, bar, row, fallsWord, episodesWord] {
    bar->setFixedHeight(scaled(48));
    row->setContentsMargins(scaled({8, 8, 12, 8}));
    row->setSpacing(scaled(8));
    falls_->setFont(scaledFont(24, 500));
    episodes_->setFont(scaledFont(13, 500));
    for (QLabel* label : {fallsWord, episodesWord}) label->setFont(scaledFont(11));
  });
  return bar;
}

void LessonView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  column_->setFixedWidth(std::min(scaled(320), static_cast<int>(kMostColumn * width())));
}

void LessonView::begin(std::size_t step) {
  nameRun();
  driver_->goOn(std::min(step, driver_->lesson().steps.size() - 1));
}

void LessonView::showHint() {
  column_->showHint();
}

void LessonView::setNext(const QString& name, const QString& title) {
  column_->setNext(name, title);
}

void LessonView::focusHome() {
  if (QWidget* world = panels_->first())
    world->setFocus(Qt::OtherFocusReason);
  else
    column_->focusFirst();
}

void LessonView::refresh() {
  const RunningLife& life = driver_->session().life();
  const auto shows = [&](const char* name) {
    const auto& show = driver_->step().show;
    return std::find(show.begin(), show.end(), name) != show.end();
  };
  const bool open = driver_->phase() == LessonDriver::Phase::Open;
  static_cast<BarButton*>(runButtons_[0])->setIcon(life.running() ? Icon::Pause : Icon::Run);
  run_->setText(life.running() ? tr("Pause") : tr("Run"));
  run_->setEnabled(shows("run") && open && !life.finished());
  restart_->setEnabled(shows("restart") && open);
  turbo_->setEnabled(shows("turbo") && open);
  turbo_->setChecked(life.turbo());
  const char* names[] = {"run", "restart", "turbo"};
  for (std::size_t i = 0; i < runButtons_.size(); ++i) runButtons_[i]->setVisible(shows(names[i]));
  for (QWidget* part : {static_cast<QWidget*>(pace_), static_cast<QWidget*>(paceWord_)})
    part->setVisible(shows("pace"));
  const bool counts = life.task().canFall;
  falls_->setText(counts ? toText(countText(static_cast<double>(life.numbers().falls))) : QString());
  QPalette palette = falls_->palette();
  if (palette.color(QPalette::WindowText) != themeOf(*this).fallText) {
    palette.setColor(QPalette::WindowText, themeOf(*this).fallText);
    falls_->setPalette(palette);
  }
  episodes_->setText(toText(countText(static_cast<double>(life.numbers().episodes))));
  nameRun();
}

/// "ε 0.25", "ε 0.05 → 0.25", "Softmax, τ 1": how a life is lived, by the knobs of the step that it began in.
QString LessonView::knobWords() const {
  const RunningLife& life = driver_->session().life();
  const Configuration &began = life.began(), &now = life.configuration();
  const Registry& registry = life.registry();
  const auto policy = findEntry(registry.policies, "policy", now.names.policy);
  const std::vector<std::string> keys = policy ? policyKeys(**policy) : std::vector<std::string>();
  const auto used = [&](const std::string& key) {
    return !key.starts_with("policy.") || std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  const auto title = [](const auto& entries, const std::string& kind, const std::string& name) {
    const auto entry = findEntry(entries, kind, name);
    return entry ? toText((*entry)->title) : toText(name);
  };
  QStringList words;
  bool named = false;
  if (hasSeveralRules()) words << title(registry.agents, "agent", now.names.agent);
  for (const std::string& name : driver_->step().show) {
    const auto *entry = now.parameters.find(name), *before = began.parameters.find(name);
    const bool otherPolicy = entry && !used(name);
    if ((name == "policy" || otherPolicy) && !named)
      words << title(registry.policies, "policy", now.names.policy), named = true;
    if (!entry || otherPolicy) continue;
    const std::string& symbol = entry->parameter.symbol;
    QString value = toText(formatValue(entry->parameter, entry->value));
    if (before && before->value != entry->value && life.changedAt(name).value_or(0) > 0)
      value = toText(formatValue(before->parameter, before->value)) + QStringLiteral(" → ") + value;
    words << QStringLiteral("%1 %2").arg(toText(symbol.empty() ? entry->parameter.title : symbol), value);
  }
  return words.mid(0, 2).join(QStringLiteral(", "));
}

/// Lives of this lesson learn by different rules: then their curves say which.
bool LessonView::hasSeveralRules() const {
  const auto changes = [&](const LessonActions& actions) {
    return std::any_of(actions.begin(), actions.end(), [&](const LessonAction& a) {
      return a.kind == LessonAction::Kind::Agent && a.value != driver_->lesson().start.names.agent;
    });
  };
  return std::any_of(driver_->lesson().steps.begin(), driver_->lesson().steps.end(), [&](const LessonStep& step) {
    const bool shown = std::find(step.show.begin(), step.show.end(), "agent") != step.show.end();
    return shown || changes(step.begin) || (step.predict && changes(step.predict->then));
  });
}

/// A curve is named when its life begins; a knob that is turned while it runs is told.
void LessonView::nameRun() {
  const RunningLife& life = driver_->session().life();
  const int number = life.curves().live().number;
  const bool isNamed = runWords_.contains(number);
  if (isNamed && !life.running() && life.progress().episodes > 0) return;
  if (isNamed && namedIn_[number] != driver_->number() && life.progress().episodes > 0) return;
  runWords_[number] = knobWords();
  namedIn_[number] = driver_->number();
}

/// After a prediction of falls the world shows the last one again: why it fell is seen before it is asked.
void LessonView::showLastFall() {
  const std::size_t now = driver_->number();
  if (now == 0 || driver_->phase() != LessonDriver::Phase::Open || !driver_->step().begin.empty()) return;
  const auto& said = driver_->lesson().steps[now - 1].predict;
  if (!said || said->of.text != "falls" || !driver_->observed(now - 1)) return;
  constexpr int kUntilTheyCame = 400;  // [ms]
  QTimer::singleShot(kUntilTheyCame, this, [this, now] {
    const bool still = driver_->number() == now && driver_->phase() == LessonDriver::Phase::Open;
    if (still && !driver_->session().life().running()) driver_->session().looking().showLastFall();
  });
}

/// ◇ while a number is said, and beside what came out in the step after it.
void LessonView::refreshPrediction() {
  const auto chartOf = [](const LessonPrediction& p) {
    return std::string(p.of.text == "falls" ? "falls" : p.of.text == "average_reward" ? "reward" : "");
  };
  const LessonStep& step = driver_->step();
  const bool episodes = step.predict && step.predict->after.unit == LessonAmount::Unit::Episodes;
  if (episodes) panels_->span().setLeast(step.predict->after.value);
  if (const auto* box = qobject_cast<PredictionBox*>(column_->question()); box && step.predict) {
    const bool given = driver_->predicted(driver_->number()).has_value();
    return panels_->setPrediction(chartOf(*step.predict),
                                  ChartPrediction{.value = driver_->predicted(driver_->number()).value_or(box->value()),
                                                  .locked = given,
                                                  .low = step.predict->low,
                                                  .high = step.predict->high,
                                                  .words = tr("your prediction")});
  }
  const std::size_t before = driver_->number() - 1;
  if (driver_->number() > 0 && driver_->lesson().steps[before].predict && driver_->predicted(before)) {
    const LessonPrediction& p = *driver_->lesson().steps[before].predict;
    return panels_->setPrediction(chartOf(p), ChartPrediction{.value = *driver_->predicted(before),
                                                              .locked = true,
                                                              .low = p.low,
                                                              .high = p.high,
                                                              .words = tr("your prediction"),
                                                              .outcome = driver_->observed(before)});
  }
  panels_->setPrediction("", std::nullopt);
}

}  // namespace surefoot

#include "moc_lesson_view.cpp"
