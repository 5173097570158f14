// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/learning_charts.h"

#include <QChart>
#include <QEvent>
#include <QGraphicsLayout>
#include <QLineSeries>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "ui/session.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

namespace {

constexpr double kLeft = 48, kRight = 92, kTop = 12, kBottom = 12, kBottomWithAxis = 40;  // gutters [px]

/// The next of 1, 2, 5 × a power of ten above the value.
double niceAbove(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-9))));
  for (const double m : {1.0, 2.0, 5.0, 10.0})
    if (m * power >= value) return m * power;
  return value;
}

double niceStep(double range) {  // at most five grid lines
  return niceAbove(range / 5.0001);
}

}  // namespace

LearningChart::LearningChart(Session& session, Shows shows, QWidget* parent)
    : QChartView(parent),
      session_(session),
      shows_(shows),
      live_(new QLineSeries) {
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
  const auto add = [&](QLineSeries* series) {
    c->addSeries(series);
    series->attachAxis(x);
    series->attachAxis(y);
  };
  for (std::size_t i = 0; i < RunCurves::kMostEarlier; ++i) add(earlier_.emplace_back(new QLineSeries));
  add(live_);
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

void LearningChart::fillSeries(QLineSeries& series, const RunCurve& curve) const {
  // At most two points a pixel column: the least and the greatest of each.
  const std::size_t columns = std::max<std::size_t>(50, static_cast<std::size_t>(plot_.width()));
  const std::size_t bucket = std::max<std::size_t>(1, 2 * curve.points.size() / (2 * columns));
  QList<QPointF> points;
  for (std::size_t i = 0; i < curve.points.size(); i += bucket) {
    const auto begin = curve.points.begin() + static_cast<std::ptrdiff_t>(i);
    const auto end = curve.points.begin() + static_cast<std::ptrdiff_t>(std::min(i + bucket, curve.points.size()));
    const auto [least, greatest] =
        std::minmax_element(begin, end, [&](const auto& a, const auto& b) { return yOf(a) < yOf(b); });
    for (const auto& point : {std::min(least, greatest), std::max(least, greatest)})
      points << QPointF(xOf(*point), yOf(*point));
  }
  series.replace(points);
}

void LearningChart::refresh() {
  if (!isVisible()) return;
  const Theme& t = themeOf(*this);
  setBackgroundBrush(t.panel);
  const RunCurves& curves = session_.curves();
  double x = session_.task().stepTime ? 1.0 : 100.0, y = 0.0;
  const auto extend = [&](const RunCurve& curve) {
    if (curve.points.empty()) return;
    x = std::max(x, xOf(curve.points.back()));
    y = std::max(y, static_cast<double>(curve.points.back().falls));
  };
  extend(curves.live());
  for (const RunCurve& curve : curves.earlier()) extend(curve);
  xMost_ = niceStep(x) * std::ceil(x / niceStep(x) - 1e-9);
  yLeast_ = shows_ == Shows::Falls ? 0.0 : session_.task().lowestReturn;
  yMost_ =
      shows_ == Shows::Falls ? std::max(10.0, niceStep(y) * std::ceil(y / niceStep(y))) : session_.task().highestReturn;
  if (yMost_ <= yLeast_) yMost_ = yLeast_ + 1;
  chart()->axes(Qt::Horizontal).front()->setRange(0, xMost_);
  chart()->axes(Qt::Vertical).front()->setRange(yLeast_, yMost_);

  fillSeries(*live_, curves.live());
  live_->setPen(QPen(policyLook(curves.live().policy, t).colour, 2));
  for (std::size_t i = 0; i < earlier_.size(); ++i) {
    if (i >= curves.earlier().size()) {
      earlier_[i]->clear();
      continue;
    }
    fillSeries(*earlier_[i], curves.earlier()[i]);
    QColor colour = policyLook(curves.earlier()[i].policy, t).colour;
    colour.setAlphaF(0.55f);
    earlier_[i]->setPen(QPen(colour, 1.25));
  }
  viewport()->update();
}

void LearningChart::place() {
  const double bottom = shows_ == Shows::Falls ? kBottomWithAxis : kBottom;
  plot_ = QRectF(kLeft, kTop, std::max(40.0, width() - kLeft - kRight), std::max(30.0, height() - kTop - bottom));
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

void LearningChart::drawBackground(QPainter* painter, const QRectF& rect) {
  QChartView::drawBackground(painter, rect);
  drawAxes(*painter, themeOf(*this));
}

void LearningChart::drawForeground(QPainter* painter, const QRectF&) {
  const Theme& t = themeOf(*this);
  if (session_.curves().live().points.empty() && session_.curves().earlier().empty()) {
    painter->setFont(textFont(11));
    painter->setPen(t.quiet);
    painter->drawText(plot_, Qt::AlignCenter,
                      shows_ == Shows::Falls ? tr("Falls appear here. None so far.")
                                             : tr("The average appears with the first episodes."));
    return;
  }
  drawChanges(*painter, t);
  if (shows_ == Shows::Falls) drawFallMarks(*painter, t);
  drawList(*painter, t);
}

void LearningChart::drawAxes(QPainter& p, const Theme& t) const {
  p.setFont(textFont(11));
  const double yStep = niceStep(yMost_ - yLeast_);
  for (double y = std::ceil(yLeast_ / yStep) * yStep; y <= yMost_ + 1e-9; y += yStep) {
    const double at = std::round(toPixel(0, y).y()) + 0.5;
    p.setPen(QPen(t.hairline, 1));
    p.drawLine(QPointF(plot_.left(), at), QPointF(plot_.right(), at));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(0, at - 8, kLeft - 8, 16), Qt::AlignRight, toText(countText(y)));
  }
  const double base = std::round(plot_.bottom()) + 0.5;
  p.setPen(QPen(t.outline, 1));
  p.drawLine(QPointF(plot_.left(), base), QPointF(plot_.right(), base));
  const double xStep = niceAbove(xMost_ / 8.0001);
  for (double x = 0; x <= xMost_ + 1e-9; x += xStep) {
    const double at = toPixel(x, 0).x();
    p.setPen(QPen(t.outline, 1));
    p.drawLine(QPointF(at, base), QPointF(at, base + 4));
    if (shows_ != Shows::Falls) continue;
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(at - 30, base + 5, 60, 16), Qt::AlignHCenter,
               xStep < 1 ? toText(fixedText(x, 1)) : toText(countText(x)));
  }
  if (shows_ == Shows::Falls)
    p.drawText(QRectF(plot_.left(), base + 20, plot_.width(), 16), Qt::AlignHCenter | Qt::AlignVCenter,
               session_.task().stepTime ? tr("simulated time [min]") : tr("episodes"));
}

void LearningChart::drawVertical(QPainter& p, const Theme& t, double x, const QString& text, int line) const {
  const double at = std::round(toPixel(x, 0).x()) + 0.5;
  QPen pen(t.ink, 1, Qt::CustomDashLine);
  pen.setDashPattern({2, 3});
  p.setPen(pen);
  p.drawLine(QPointF(at, plot_.top()), QPointF(at, plot_.bottom()));
  if (text.isEmpty()) return;
  p.setFont(textFont(11));
  const double w = symbolWidth(p.font(), text) + 4;
  const bool right = at + 5 + w < plot_.right();
  const QRectF where(right ? at + 4 : at - 4 - w, plot_.bottom() - 18 - 15 * line, w, 15);
  QColor veil = t.panel;
  veil.setAlphaF(0.8f);
  p.fillRect(where, veil);
  p.setPen(t.quiet);
  drawSymbol(p, where, Qt::AlignLeft, text);
}

QString LearningChart::textOf(const Change& change) const {
  const QString values = QStringLiteral("%1 → %2");
  if (change.key == "policy") {
    const auto title = [&](const std::string& name) {
      const auto entry = findEntry(session_.registry().policies, "policy", name);
      return toText(entry ? (*entry)->title : name);
    };
    return values.arg(title(change.before), title(change.after));
  }
  const auto* entry = session_.configuration().parameters.find(change.key);
  const QString title = toText(entry ? entry->parameter.title : change.key).toLower();
  return title + ' ' + values.arg(toText(change.before), toText(change.after)).replace('-', QChar(0x2212));
}

void LearningChart::drawChanges(QPainter& p, const Theme& t) const {
  const ValueSnapshot* v = session_.values();
  if (!v || shows_ == Shows::Falls) return;
  const double perStep = session_.task().stepTime.value_or(0.0) / 60.0;
  if (perStep <= 0) return;
  // A slider that is drawn makes many changes; those of one parameter that follow closely are one line.
  std::vector<Change> groups;
  const double near = 0.04 * xMost_ / perStep;
  for (const Change& change : v->changes) {
    if (!groups.empty() && groups.back().key == change.key &&
        static_cast<double>(change.step - groups.back().step) < near)
      groups.back().after = change.after;
    else
      groups.push_back(change);
  }
  constexpr std::size_t kMost = 12;
  for (std::size_t i = groups.size() > kMost ? groups.size() - kMost : 0; i < groups.size(); ++i) {
    if (groups[i].before == groups[i].after) continue;
    drawVertical(p, t, static_cast<double>(groups[i].step) * perStep, textOf(groups[i]), static_cast<int>(i % 3));
  }
  if (v->endOfLearning > 0)
    drawVertical(p, t, static_cast<double>(v->endOfLearningSteps) * perStep, tr("end of learning"), 3);
}

void LearningChart::drawFallMarks(QPainter& p, const Theme& t) const {
  const auto& points = session_.curves().live().points;
  p.setPen(QPen(t.fall, 1));
  double last = -10;
  std::int64_t falls = 0;
  for (const CurvePoint& point : points) {
    const double at = std::round(toPixel(xOf(point), 0).x()) + 0.5;
    if (point.falls > falls && at - last >= 2) {
      p.drawLine(QPointF(at, plot_.bottom() - 8), QPointF(at, plot_.bottom() - 1));
      last = at;
      falls = point.falls;
    }
  }
}

void LearningChart::drawList(QPainter& p, const Theme& t) const {
  struct Item {
    double value;
    std::string policy;
    bool live;
  };
  std::vector<Item> items;
  const RunCurves& curves = session_.curves();
  for (const RunCurve& c : curves.earlier()) items.push_back({yOf(c.points.back()), c.policy, false});
  if (!curves.live().points.empty()) {
    const double falls = static_cast<double>(session_.snapshot().totals.falls);  // as new as the counter in the toolbar
    const double value = shows_ == Shows::Falls ? falls : yOf(curves.live().points.back());
    items.push_back({value, curves.live().policy, true});
  }
  std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.value > b.value; });
  double y = plot_.top() + 2;
  for (const Item& item : items) {
    drawMarker(p, {plot_.right() + 12, y}, policyLook(item.policy, t), item.live);
    const auto entry = findEntry(session_.registry().policies, "policy", item.policy);
    QString text = shows_ == Shows::Falls ? toText(countText(item.value)) : entry ? toText((*entry)->title) : QString();
    if (item.live && shows_ == Shows::AverageReward) text += tr(", live");
    p.setFont(textFont(11, item.live ? 500 : 400));
    p.setPen(item.live ? t.ink : t.quiet);
    drawSymbol(p, QRectF(plot_.right() + 20, y - 8, kRight - 22, 16), Qt::AlignLeft, text);
    y += 15;
  }
}

}  // namespace surefoot
