// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/charts/learning_charts.h"

#include <fmt/format.h>

#include <QChart>
#include <QEvent>
#include <QGraphicsLayout>
#include <QLineSeries>
#include <QValueAxis>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/session/history.h"
#include "ui/style/policy_look.h"
#include "ui/style/round_numbers.h"
#include "ui/style/theme.h"

namespace surefoot {

LearningChart::LearningChart(RunningLife& life, Looking& looking, History& history, ChartSpan& span, Shows shows,
                             QWidget* parent)
    : Painted(parent),
      life_(life),
      looking_(looking),
      history_(history),
      span_(span),
      shows_(shows) {
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::StrongFocus);
  viewport()->setMouseTracking(true);
  setRenderHint(QPainter::Antialiasing);
  QChart* c = chart();
  c->legend()->hide();
  c->setMargins({});
  c->layout()->setContentsMargins(0, 0, 0, 0);
  c->setBackgroundVisible(false);
  c->setAnimationOptions(QChart::NoAnimation);
  auto *x = new QValueAxis, *y = new QValueAxis;
  x->setVisible(false);
  y->setVisible(false);
  c->addAxis(x, Qt::AlignBottom);
  c->addAxis(y, Qt::AlignLeft);
  for (const auto changed : {&RunningLife::valuesArrived, &RunningLife::replaced, &RunningLife::configurationChanged,
                             &RunningLife::curvesChanged})
    connect(&life_, changed, this, &LearningChart::refresh);
  connect(&span_, &ChartSpan::changed, this, &LearningChart::refresh);
  connect(&span_, &ChartSpan::cursorChanged, this, [this] {
    setAccessibleDescription(reading());
    viewport()->update();
  });
  refresh();
}

double LearningChart::xOf(const CurvePoint& point) const {
  return span_.timeOf(point);
}

double LearningChart::yOf(const CurvePoint& point) const {
  return shows_ == Shows::Falls ? static_cast<double>(point.falls) : point.averageReward;
}

std::string LearningChart::asCsv() const {
  const std::vector<Run> list = runs();
  if (list.empty()) return "";
  std::string csv = fmt::format("life,policy,{},{}\n", span_.inMinutes() ? "minutes" : "episode",
                                shows_ == Shows::Falls ? "falls" : "average_reward");
  std::size_t life = list.size() - (secondCurve() ? 2 : 1);
  if (life_.curves().live().points.empty()) ++life;  // the newest earlier life has the number 1 in any case
  for (const Run& run : list) {
    const std::string name = run.kind == Run::Kind::Live     ? "0"
                             : run.kind == Run::Kind::Second ? "second"
                                                             : std::to_string(life--);
    auto piece = run.curve->pieces.begin();
    for (const CurvePoint& point : run.curve->points) {
      while (piece + 1 != run.curve->pieces.end() && (piece + 1)->from < point.lifeSteps) ++piece;
      csv += fmt::format("{},{},{:.9g},{:.9g}\n", name, piece->policy, xOf(point), yOf(point));
    }
  }
  return csv;
}

/// Draws the first, the least, the greatest and the last point of each column of pixels; all points if they are few.
void LearningChart::drawPiece(std::size_t index, const std::vector<CurvePoint>& piece, const QPen& pen, bool fromZero) {
  while (series_.size() <= index) {
    series_.push_back(new QLineSeries);
    chart()->addSeries(series_.back());
    series_.back()->attachAxis(chart()->axes(Qt::Horizontal).front());
    series_.back()->attachAxis(chart()->axes(Qt::Vertical).front());
  }
  const auto before = [this](double x) { return [this, x](const CurvePoint& p) { return xOf(p) < x; }; };
  auto begin = std::partition_point(piece.begin(), piece.end(), before(span_.from()));
  auto end = std::partition_point(begin, piece.end(), before(span_.to()));
  if (begin != piece.begin()) --begin;  // the curve goes on beyond the edges
  if (end != piece.end()) ++end;
  QList<QPointF> points;
  if (fromZero && begin == piece.begin()) points << QPointF(0, 0);
  while (begin != end) {
    const double column = std::floor(toPixel(xOf(*begin), 0).x());
    auto next = begin + 1;
    while (next != end && std::floor(toPixel(xOf(*next), 0).x()) == column) ++next;
    const auto [least, greatest] =
        std::minmax_element(begin, next, [&](const auto& a, const auto& b) { return yOf(a) < yOf(b); });
    auto shown = piece.end();
    for (const auto& point : {begin, std::min(least, greatest), std::max(least, greatest), next - 1}) {
      if (std::exchange(shown, point) == point) continue;
      // A count stays as it is until it changes.
      if (shows_ == Shows::Falls && !points.isEmpty()) points << QPointF(xOf(*point), points.back().y());
      points << QPointF(xOf(*point), yOf(*point));
    }
    begin = next;
  }
  series_[index]->replace(points);
  series_[index]->setPen(pen);
}

/// Extends the range to grid lines; there are as many lines as have room with their numbers.
void LearningChart::roundRange(double least, double most) {
  const double lines = std::clamp(std::floor(plot_.height() / (1.2 * QFontMetricsF(textFont(11)).height())), 2.0, 5.0);
  yStep_ = niceAbove((most - least) / (lines + 1e-4));
  const auto low = [&] { return std::floor(least / yStep_ + 1e-9); };
  const auto high = [&] { return std::ceil(most / yStep_ - 1e-9); };
  while (high() - low() > lines) yStep_ = niceAbove(1.001 * yStep_);
  yLeast_ = low() * yStep_;
  yMost_ = high() * yStep_;
}

/// From 0 to the values of the curves and the greedy tests, within the task's returns; and a little more, so that no
/// curve lies on the frame.
void LearningChart::chooseRewards() {
  const Task& task = life_.task();
  double least = 0, most = 0;
  const auto include = [&](double x, double value) {
    if (x < span_.from() || x > span_.to()) return;
    least = std::min(least, value);
    most = std::max(most, value);
  };
  for (const Run& run : runs())
    for (const CurvePoint& point : run.curve->points) include(xOf(point), yOf(point));
  if (const ValueSnapshot* v = life_.values())
    for (const GreedyTest& test : v->tests) include(span_.timeOf(test.episode, test.lifeSteps), test.reward);
  least = std::max(least, std::min(task.lowestReturn, 0.0));
  most = std::min(most, std::max(task.highestReturn, 0.0));
  if (least == most) least = task.lowestReturn, most = std::max(task.highestReturn, least + 1);  // nothing yet
  roundRange(least, most);
  constexpr double kBeyond = 4;  // [px]
  const double beyond = kBeyond * (yMost_ - yLeast_) / std::max(plot_.height() - 2 * kBeyond, 1.0);
  yLeast_ -= beyond;
  yMost_ += beyond;
}

void LearningChart::chooseRanges() {
  double least = kInfinity, most = 0.0;
  for (const Run& run : runs()) {
    if (const CurvePoint* at = stateAt(*run.curve, span_.to())) most = std::max(most, static_cast<double>(at->falls));
    const CurvePoint* before = stateAt(*run.curve, span_.from());
    least = std::min(least, before ? static_cast<double>(before->falls) : 0.0);
  }
  if (shows_ == Shows::Falls) {
    const bool part = span_.shows() == ChartSpan::Shows::Part && least < most;
    if (!part) least = 0;
    roundRange(least, std::max(most, least + 10));
    if (prediction_ && !part) fitPrediction(most);
  } else {
    chooseRewards();
  }
  chart()->axes(Qt::Horizontal).front()->setRange(span_.from(), span_.to());
  chart()->axes(Qt::Vertical).front()->setRange(yLeast_, yMost_);
}

void LearningChart::setSecond(RunningLife* second) {
  second_ = second;
  span_.setSecond(second);
  refresh();
}

/// The second learner's curve; nullptr: there is none, or it has no episode yet.
const RunCurve* LearningChart::secondCurve() const {
  return second_ && !second_->curves().live().points.empty() ? &second_->curves().live() : nullptr;
}

std::vector<LearningChart::Run> LearningChart::runs() const {
  std::vector<Run> list;
  for (const RunCurve& curve : life_.curves().earlier()) list.push_back({&curve, Run::Kind::Earlier});
  if (const RunCurve* second = secondCurve()) list.push_back({second, Run::Kind::Second});
  if (const RunCurve& live = life_.curves().live(); !live.points.empty()) list.push_back({&live, Run::Kind::Live});
  return list;
}

const CurvePoint* LearningChart::stateAt(const RunCurve& curve, double time) const {
  const auto after = std::partition_point(curve.points.begin(), curve.points.end(),
                                          [&](const CurvePoint& p) { return xOf(p) <= time; });
  return after == curve.points.begin() ? nullptr : &*std::prev(after);
}

void LearningChart::prepareExport(bool exporting) {
  exporting_ = exporting;
  refresh();
}

void LearningChart::refresh() {
  if (!isVisible()) return;
  place();
  const Theme& t = themeOf(*this);
  setBackgroundBrush(t.panel);
  chooseRanges();
  constexpr std::size_t kMostPieces = 24;  // per curve: nobody changes the policy more often by hand
  std::size_t used = 0;
  for (const Run& run : runs()) {
    const bool earlier = run.kind == Run::Kind::Earlier;
    for (std::size_t i = 0; i < std::min(run.curve->pieces.size(), kMostPieces); ++i) {
      QColor colour = policyLook(run.curve->pieces[i].policy, t).colour;
      if (earlier) colour.setAlphaF(0.55f);
      QPen pen(colour, earlier ? 1.25 : 2);
      if (run.curve->agent == "sarsa-2q") pen.setDashPattern({5, 2.5});  // the dash shows the learning rule
      const bool fromZero = shows_ == Shows::Falls && i == 0 && run.curve->points.front().episode == 1;
      drawPiece(used++, run.curve->pieces[i].points, pen, fromZero);
    }
  }
  for (std::size_t i = used; i < series_.size(); ++i) series_[i]->clear();
  viewport()->update();
}

/// Charts that stand one above the other share one axis. If one is moved, floats or is behind a tab, each has its own.
bool LearningChart::hasTimeAxis() const {
  if (exporting_ || !below_ || !below_->isVisible() || below_->window() != window()) return true;
  constexpr int kHeader = 80;  // [px] between the two at most
  const QRect mine(mapToGlobal(QPoint()), size()), its(below_->mapToGlobal(QPoint()), below_->size());
  return mine.left() != its.left() || mine.width() != its.width() || its.top() < mine.bottom() ||
         its.top() > mine.bottom() + kHeader;
}

/// The places of the panels are known only after their layout: then the plot may get another size.
void LearningChart::paintEvent(QPaintEvent* event) {
  if (withAxis_ != hasTimeAxis()) QMetaObject::invokeMethod(this, &LearningChart::refresh, Qt::QueuedConnection);
  Painted::paintEvent(event);
}

void LearningChart::place() {
  withAxis_ = hasTimeAxis();
  const double bottom = withAxis_ ? kBottomWithAxis : kBottom;
  const double top = exporting_ ? kTopWithTitle : kTop;
  setTransform(QTransform::fromScale(textSize(), textSize()));
  chart()->resize(QSizeF(size()));
  setSceneRect(chart()->geometry());
  plot_ = QRectF(kLeft, top, std::max(40.0, width() - kLeft - listWidth()), std::max(30.0, height() - top - bottom));
  chart()->setPlotArea(plot_);
}

void LearningChart::resizeEvent(QResizeEvent* event) {
  QChartView::resizeEvent(event);
  place();
  refresh();
}

void LearningChart::changeEvent(QEvent* event) {
  QChartView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) refresh();
}

QPointF LearningChart::toPixel(double x, double y) const {
  return {plot_.left() + (x - span_.from()) / (span_.to() - span_.from()) * plot_.width(),
          plot_.bottom() - (y - yLeast_) / (yMost_ - yLeast_) * plot_.height()};
}

double LearningChart::timeAt(double pixel) const {
  return span_.from() + (pixel - plot_.left()) / plot_.width() * (span_.to() - span_.from());
}

}  // namespace surefoot

#include "moc_learning_charts.cpp"
