// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/charts/chart_span.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/running/running_life.h"
#include "ui/style/round_numbers.h"

namespace surefoot {

namespace {

constexpr double kBehindLearning = 1.2;  // times the time of learning is shown
constexpr double kPressed = 3.0;         // times: in a longer life, learning is pressed against the axis
constexpr double kClosest = 1.0 / 2000;  // least share of the life that is shown: curves have no finer detail

/// A round number that is not below the end.
double roundEnd(double end) {
  const double step = niceAbove(end / 5.0001);
  return step * std::ceil(end / step - 1e-9);
}

}  // namespace

bool ChartSpan::inMinutes() const {
  return life_.task().stepTime && !episodes_;
}

void ChartSpan::countEpisodes(bool episodes) {
  episodes_ = episodes;
  wish(std::nullopt);
}

void ChartSpan::setLeast(double least) {
  if (std::exchange(least_, least) != least) wish(wished_);
}

double ChartSpan::timeOf(std::int64_t episode, std::int64_t lifeSteps) const {
  return inMinutes() ? static_cast<double>(lifeSteps) * *life_.task().stepTime / 60.0 : static_cast<double>(episode);
}

double ChartSpan::endOf(const RunCurve& curve) const {
  return curve.points.empty() ? 0.0 : timeOf(curve.points.back());
}

ChartSpan::ChartSpan(RunningLife& life, QObject* parent) : QObject(parent), life_(life) {
  connect(&life_, &RunningLife::valuesArrived, this, &ChartSpan::refresh);
  connect(&life_, &RunningLife::configurationChanged, this, &ChartSpan::refresh);
  connect(&life_, &RunningLife::replaced, this, [this] {
    const bool another = std::exchange(lineage_, life_.lineage()) != life_.lineage();
    if (wished_ == Shows::Part && another) wished_.reset();  // the chosen part belongs to a life that is over
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
  return v && v->endOfLearning > 0 ? timeOf(v->endOfLearning, v->endOfLearningSteps) : 0.0;
}

double ChartSpan::whole() const {
  const RunCurves& curves = life_.curves();
  const bool clock = inMinutes();
  double end = std::max(endOf(curves.live()), least_ > 0 ? least_ : clock ? 1.0 : 100.0);
  if (second_) end = std::max(end, endOf(second_->curves().live()));
  // A much longer earlier life must not press the present one against the axis: its curve is cut.
  const double most = std::max(2 * end, clock ? 10.0 : 1000.0);
  for (const RunCurve& curve : curves.earlier()) end = std::max(end, std::min(endOf(curve), most));
  return end;
}

ChartSpan::Shows ChartSpan::shows() const {
  if (wished_) return *wished_;
  const double learned = endOfLearning();
  const auto& points = life_.curves().live().points;
  const bool seen = !points.empty() && timeOf(points.front()) < learned;  // else nobody looked while it learned
  return seen && whole() > kPressed * learned ? Shows::Learning : Shows::WholeLife;
}

void ChartSpan::refresh() {
  if (shows() == Shows::Part) return;
  const double learned = endOfLearning();
  const bool learning = shows() == Shows::Learning && learned > 0;
  const double from = 0, end = learning ? kBehindLearning * learned : whole();
  const double to = least_ > 0 && end <= least_ ? least_ : roundEnd(end);
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
  const double least = std::max(kClosest * to, inMinutes() ? 0.005 : 2.0);
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
