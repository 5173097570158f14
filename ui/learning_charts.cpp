// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/learning_charts.h"

#include <fmt/format.h>

#include <QChart>
#include <QEvent>
#include <QGraphicsLayout>
#include <QLineSeries>
#include <QMouseEvent>
#include <QValueAxis>
#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/session.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

double niceAbove(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-9))));
  for (const double m : {1.0, 2.0, 5.0})
    if (m * power >= value) return m * power;
  return 10.0 * power;
}

LearningChart::LearningChart(Session& session, Shows shows, QWidget* parent)
    : QChartView(parent),
      session_(session),
      shows_(shows) {
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
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
  connect(&session_, &Session::valuesArrived, this, &LearningChart::refresh);
  connect(&session_, &Session::lifeReplaced, this, &LearningChart::refresh);
  connect(&session_, &Session::configurationChanged, this, &LearningChart::refresh);
  refresh();
}

double LearningChart::xOf(const CurvePoint& point) const {
  const auto& stepTime = session_.task().stepTime;
  return stepTime ? static_cast<double>(point.lifeSteps) * *stepTime / 60.0 : static_cast<double>(point.episode);
}

double LearningChart::yOf(const CurvePoint& point) const {
  return shows_ == Shows::Falls ? static_cast<double>(point.falls) : point.averageReward;
}

std::string LearningChart::asCsv() const {
  const RunCurves& curves = session_.curves();
  if (curves.live().points.empty() && curves.earlier().empty()) return "";
  std::string csv = fmt::format("life,policy,{},{}\n", session_.task().stepTime ? "minutes" : "episode",
                                shows_ == Shows::Falls ? "falls" : "average_reward");
  const auto add = [&](const auto& life, const RunCurve& curve) {
    for (const CurvePiece& piece : curve.pieces)
      for (const CurvePoint& point : piece.points)
        csv += fmt::format("{},{},{:.9g},{:.9g}\n", life, piece.policy, xOf(point), yOf(point));
  };
  add(0, curves.live());
  if (const RunCurve* second = secondCurve()) add("second", *second);
  for (std::size_t i = 0; i < curves.earlier().size(); ++i) add(curves.earlier().size() - i, curves.earlier()[i]);
  return csv;
}

void LearningChart::drawPiece(std::size_t index, const std::vector<CurvePoint>& piece, const QPen& pen) {
  while (series_.size() <= index) {
    series_.push_back(new QLineSeries);
    chart()->addSeries(series_.back());
    series_.back()->attachAxis(chart()->axes(Qt::Horizontal).front());
    series_.back()->attachAxis(chart()->axes(Qt::Vertical).front());
  }
  // At most two points a pixel column: the least and the greatest of each.
  const auto columns = static_cast<std::size_t>(std::max(50.0, plot_.width()));
  const auto shown = static_cast<std::size_t>(
      std::partition_point(piece.begin(), piece.end(), [&](const auto& p) { return xOf(p) <= xMost_; }) -
      piece.begin());
  const std::size_t bucket = std::max<std::size_t>(1, shown / columns);
  QList<QPointF> points;
  for (std::size_t i = 0; i < piece.size(); i += bucket) {
    if (i > 0 && xOf(piece[i]) > xMost_) break;
    const auto begin = piece.begin() + static_cast<std::ptrdiff_t>(i);
    const auto end = piece.begin() + static_cast<std::ptrdiff_t>(std::min(i + bucket, piece.size()));
    const auto [least, greatest] =
        std::minmax_element(begin, end, [&](const auto& a, const auto& b) { return yOf(a) < yOf(b); });
    for (const auto& point : {std::min(least, greatest), std::max(least, greatest)})
      points << QPointF(xOf(*point), yOf(*point));
  }
  series_[index]->replace(points);
  series_[index]->setPen(pen);
}

void LearningChart::chooseRanges() {
  const RunCurves& curves = session_.curves();
  const auto endOf = [&](const RunCurve& curve) { return curve.points.empty() ? 0.0 : xOf(curve.points.back()); };
  const bool clock = session_.task().stepTime.has_value();
  // A long life before must not press the one that runs against the axis: it is cut where it is much longer.
  const double live = std::max(endOf(curves.live()), clock ? 1.0 : 100.0);
  double x = live;
  for (const RunCurve& curve : curves.earlier())
    x = std::max(x, std::min(endOf(curve), std::max(2 * live, clock ? 10.0 : 1000.0)));
  const ValueSnapshot* v = session_.values();
  if (learningOnly_ && v && v->endOfLearning > 0) {
    CurvePoint end;
    end.episode = static_cast<std::int64_t>(v->endOfLearning);
    end.lifeSteps = static_cast<std::int64_t>(v->endOfLearningSteps);
    x = 1.2 * xOf(end);
  }
  xMost_ = niceAbove(x / 5.0001) * std::ceil(x / niceAbove(x / 5.0001) - 1e-9);

  double falls = 0.0;
  const auto count = [&](const RunCurve& curve) {
    for (const CurvePoint& point : curve.points)
      if (xOf(point) <= xMost_) falls = std::max(falls, static_cast<double>(point.falls));
  };
  count(curves.live());
  if (const RunCurve* second = secondCurve()) count(*second);
  for (const RunCurve& curve : curves.earlier()) count(curve);
  const double step = niceAbove(falls / 5.0001);
  yLeast_ = shows_ == Shows::Falls ? 0.0 : session_.task().lowestReturn;
  yMost_ = shows_ == Shows::Falls ? std::max(10.0, step * std::ceil(falls / step)) : session_.task().highestReturn;
  if (yMost_ <= yLeast_) yMost_ = yLeast_ + 1;
  chart()->axes(Qt::Horizontal).front()->setRange(0, xMost_);
  chart()->axes(Qt::Vertical).front()->setRange(yLeast_, yMost_);
}

void LearningChart::setSecond(Session* second) {
  second_ = second;
  refresh();
}

/// nullptr: there is none, or it has no episode yet.
const RunCurve* LearningChart::secondCurve() const {
  return second_ && !second_->curves().live().points.empty() ? &second_->curves().live() : nullptr;
}

void LearningChart::setLearningOnly(bool on) {
  learningOnly_ = on;
  refresh();
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
  const RunCurves& curves = session_.curves();
  constexpr std::size_t kMostPieces = 24;  // of one curve: policies are not changed oftener by hand
  std::size_t used = 0;
  const auto draw = [&](const RunCurve& curve, bool live) {
    for (std::size_t i = 0; i < std::min(curve.pieces.size(), kMostPieces); ++i) {
      QColor colour = policyLook(curve.pieces[i].policy, t).colour;
      if (!live) colour.setAlphaF(0.55f);
      QPen pen(colour, live ? 2 : 1.25);
      if (curve.agent == "sarsa-2q") pen.setDashPattern({5, 2.5});  // the dash says the learning rule
      drawPiece(used++, curve.pieces[i].points, pen);
    }
  };
  for (const RunCurve& curve : curves.earlier()) draw(curve, false);
  if (const RunCurve* second = secondCurve()) draw(*second, true);
  draw(curves.live(), true);
  for (std::size_t i = used; i < series_.size(); ++i) series_[i]->clear();
  viewport()->update();
}

void LearningChart::place() {
  const double bottom = hasTimeAxis() ? kBottomWithAxis : kBottom;
  const double top = exporting_ ? kTopWithTitle : kTop;
  plot_ = QRectF(kLeft, top, std::max(40.0, width() - kLeft - kRight), std::max(30.0, height() - top - bottom));
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
  return {plot_.left() + x / xMost_ * plot_.width(),
          plot_.bottom() - (y - yLeast_) / (yMost_ - yLeast_) * plot_.height()};
}

// A click on the marks of falls replays the one nearest to it that is still kept.
void LearningChart::mousePressEvent(QMouseEvent* event) {
  constexpr double kNear = 5;  // [px]
  if (shows_ != Shows::Falls || std::abs(event->position().y() - (plot_.bottom() - 4)) > 8) return;
  const auto& stepTime = session_.task().stepTime;
  double least = kNear;
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < session_.falls().size(); ++i) {
    const Fall& fall = session_.falls()[i];
    const double x =
        stepTime ? static_cast<double>(fall.lifeSteps) * *stepTime / 60.0 : static_cast<double>(fall.episode);
    const double distance = std::abs(toPixel(x, 0).x() - event->position().x());
    if (distance <= least) least = distance, nearest = i;
  }
  if (nearest) session_.replayFall(*nearest);
}

}  // namespace surefoot
