// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/lesson_view.h"

#include <QAction>
#include <QHBoxLayout>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/controls/hairline.h"
#include "ui/lessons/questions/prediction_box.h"
#include "ui/lessons/taking/lesson_bar.h"
#include "ui/lessons/taking/lesson_column.h"
#include "ui/lessons/taking/lesson_panels.h"
#include "ui/style/scale.h"

namespace surefoot {

LessonView::LessonView(const Registry& registry, Lesson lesson, HandIn handIn, QWidget* parent)
    : QWidget(parent),
      driver_(std::make_unique<LessonDriver>(registry, std::move(lesson), std::move(handIn))),
      names_(*driver_),
      bar_(new LessonBar(*driver_, this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(bar_);
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
  makeActions();
  panels_->setRunWords([this](const RunCurve& curve) { return names_.of(curve); });
  connect(bar_, &LessonBar::allLessonsAsked, this, &LessonView::allLessonsAsked);
  connect(bar_, &LessonBar::teacherAsked, this, &LessonView::teacherAsked);
  connect(bar_, &LessonBar::refused, this, &LessonView::refused);
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
  connect(&life, &RunningLife::configurationChanged, this, [this] { names_.note(); });
  connect(&driver_->session().looking(), &Looking::fallReplayed, driver_.get(), &LessonDriver::noteReplay);
}

LessonView::~LessonView() {
  // The panels know the session, which belongs to the driver.
  delete panels_;
  delete column_;
  delete bar_;
}

/// Alt and an arrow go on from wherever the focus is in the window; single keys only within the lesson.
void LessonView::makeActions() {
  addActions(bar_->keyActions());
  const auto act = [this](const QString& text, Qt::Key key, const std::function<void()>& what) {
    auto* action = new QAction(text, this);
    action->setShortcut(QKeySequence(Qt::ALT | key));
    connect(action, &QAction::triggered, this, what);
    addAction(action);
  };
  act(tr("Next"), Qt::Key_Right, [this] { column_->goOn(); });
  act(tr("Back"), Qt::Key_Left, [this] { column_->goBack(); });
}

void LessonView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  column_->setFixedWidth(std::min(scaled(320), static_cast<int>(kMostColumn * width())));
}

void LessonView::begin(std::size_t step) {
  names_.note();
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
  bar_->refresh();
  names_.note();
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

/// The time of the life that a prediction is about, as the charts count it; none: they count otherwise.
std::optional<double> LessonView::timeOf(const LessonPrediction& prediction, std::size_t step) const {
  const bool minutes = panels_->span().inMinutes();
  if (prediction.after.unit != (minutes ? LessonAmount::Unit::Minutes : LessonAmount::Unit::Episodes))
    return std::nullopt;
  if (!driver_->keepsLife(prediction.then)) return prediction.after.value;
  // The life goes on: the time counts from where it was when the step began.
  const auto arrived = driver_->arrivedAt(step);
  if (!arrived) return std::nullopt;
  return prediction.after.value + panels_->span().timeOf(arrived->first, arrived->second);
}

/// ◇ while a number is said, and beside what came out in the step after it.
void LessonView::refreshPrediction() {
  const auto chartOf = [](const LessonPrediction& p) {
    return std::string(p.of.text == "falls" ? "falls" : p.of.text == "average_reward" ? "reward" : "");
  };
  const LessonStep& step = driver_->step();
  const auto counted = panels_->span().inMinutes() ? LessonAmount::Unit::Minutes : LessonAmount::Unit::Episodes;
  if (step.predict && step.predict->after.unit == counted) panels_->span().setLeast(step.predict->after.value);
  if (const auto* box = qobject_cast<PredictionBox*>(column_->question()); box && step.predict) {
    const bool given = driver_->predicted(driver_->number()).has_value();
    return panels_->setPrediction(chartOf(*step.predict),
                                  ChartPrediction{.value = driver_->predicted(driver_->number()).value_or(box->value()),
                                                  .locked = given,
                                                  .low = step.predict->low,
                                                  .high = step.predict->high,
                                                  .words = tr("your prediction"),
                                                  .at = timeOf(*step.predict, driver_->number())});
  }
  const std::size_t before = driver_->number() - 1;
  if (driver_->number() > 0 && driver_->lesson().steps[before].predict && driver_->predicted(before)) {
    const LessonPrediction& p = *driver_->lesson().steps[before].predict;
    return panels_->setPrediction(chartOf(p), ChartPrediction{.value = *driver_->predicted(before),
                                                              .locked = true,
                                                              .low = p.low,
                                                              .high = p.high,
                                                              .words = tr("your prediction"),
                                                              .outcome = driver_->observed(before),
                                                              .at = timeOf(p, before)});
  }
  panels_->setPrediction("", std::nullopt);
}

}  // namespace surefoot

#include "moc_lesson_view.cpp"
