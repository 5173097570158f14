// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/charts/chart_span.h"

#include <algorithm>
#include <cmath>

#include "ui/running/running_life.h"
#include "ui/style/round_numbers.h"

namespace surefoot {

namespace {

constexpr double kBehindLearning = 1.2;  // times the time of learning is shown
constexpr double kPressed = 3.0;         // times: in a longer life, learning is pressed against the axis
constexpr double kClosest = 1.0 / 2000;  // least share of the life that is shown: curves have no finer detail

double endOf(const Task& task, const RunCurve& curve) {
  return curve.points.empty() ? 0.0 : timeOf(task, curve.points.back());
}

/// A round number that is not below the end.
double roundEnd(double end) {
  const double step = niceAbove(end / 5.0001);
  return step * std::ceil(end / step - 1e-9);
}

}  // namespace

double timeOf(const Task& task, std::int64_t episode, std::int64_t lifeSteps) {
  return task.stepTime ? static_cast<double>(lifeSteps) * *task.stepTime / 60.0 : static_cast<double>(episode);
}

ChartSpan::ChartSpan(RunningLife& life, QObject* parent) : QObject(parent), life_(life) {
  connect(&life_, &RunningLife::valuesArrived, this, &ChartSpan::refresh);
  connect(&life_, &RunningLife::configurationChanged, this, &ChartSpan::refresh);
  connect(&life_, &RunningLife::replaced, this, [this] {
    if (wished_ == Shows::Part) wished_.reset();  // the chosen part belongs to a life that is over
    refresh();
  });
  refresh();
}

void ChartSpan::setSecond(RunningLife* second) {
  second_ = second;
  refresh();
}

double ChartSpan::endOfLearning() const {
  const ValueSnapshot* v = life_.values();
  return v && v->endOfLearning > 0 ? timeOf(life_.task(), v->endOfLearning, v->endOfLearningSteps) : 0.0;
}

double ChartSpan::whole() const {
  const Task& task = life_.task();
  const RunCurves& curves = life_.curves();
  const bool clock = task.stepTime.has_value();
  double end = std::max(endOf(task, curves.live()), clock ? 1.0 : 100.0);
  if (second_) end = std::max(end, endOf(task, second_->curves().live()));
  // A much longer earlier life must not press the present one against the axis: its curve is cut.
  const double most = std::max(2 * end, clock ? 10.0 : 1000.0);
  for (const RunCurve& curve : curves.earlier()) end = std::max(end, std::min(endOf(task, curve), most));
  return end;
}

ChartSpan::Shows ChartSpan::shows() const {
  if (wished_) return *wished_;
  const double learned = endOfLearning();
  return learned > 0 && whole() > kPressed * learned ? Shows::Learning : Shows::WholeLife;
}

void ChartSpan::refresh() {
  if (shows() == Shows::Part) return;
  const double learned = endOfLearning();
  const bool learning = shows() == Shows::Learning && learned > 0;
  const double from = 0, to = roundEnd(learning ? kBehindLearning * learned : whole());
  if (from == from_ && to == to_) return;
  from_ = from, to_ = to;
  Q_EMIT changed();
}

void ChartSpan::wish(std::optional<Shows> shows) {
  wished_ = shows;
  from_ = to_ = 0;  // so that any new range counts as a change
  refresh();
}

void ChartSpan::showWholeLife() {
  wish(Shows::WholeLife);
}

void ChartSpan::showLearning() {
  wish(Shows::Learning);
}

void ChartSpan::showPart(double from, double to) {
  const double end = roundEnd(whole());
  from = std::clamp(from, 0.0, end);
  to = std::clamp(to, from, end);
  const double least = std::max(kClosest * to, life_.task().stepTime ? 0.005 : 2.0);
  if (to - from < least) {
    const double middle = (from + to) / 2;
    from = std::clamp(middle - least / 2, 0.0, end - least);
    to = from + least;
  }
  if (from <= 0 && to >= end) return showWholeLife();
  wished_ = Shows::Part;
  from_ = from, to_ = to;
  Q_EMIT changed();
}

void ChartSpan::zoom(double factor, double anchor) {
  showPart(anchor - (anchor - from_) * factor, anchor + (to_ - anchor) * factor);
}

void ChartSpan::pan(double share) {
  const double span = to_ - from_, end = roundEnd(whole());
  const double from = std::clamp(from_ + share * span, 0.0, std::max(0.0, end - span));
  if (from != from_) showPart(from, from + span);
}

void ChartSpan::setCursor(std::optional<double> at) {
  if (at == cursor_) return;
  cursor_ = at;
  Q_EMIT cursorChanged();
}

}  // namespace surefoot

#include "moc_chart_span.cpp"
