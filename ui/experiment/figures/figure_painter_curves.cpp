// SPDX-License-Identifier: GPL-3.0-or-later
// Curves with their bands, and the list of their names.
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/experiment/figures/figure_painter.h"
#include "ui/style/policy_look.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr double kStroke = 28, kNear = 10;  // length of a stroke in the list; reach of the mouse around a curve [px]

bool known(const Interval& i) {
  return std::isfinite(i.low) && std::isfinite(i.high);
}

double rowHeight() {
  return QFontMetricsF(textFont(11)).height() + 3;
}

/// Solid Sarsa, dashed Sarsa_2Q, dotted the others.
QList<qreal> dashOf(const std::string& agent) {
  if (agent.empty() || agent == "sarsa") return {};
  return agent == "sarsa-2q" ? QList<qreal>{6, 3} : QList<qreal>{1.5, 2.5};
}

}  // namespace

QPen FigurePainter::penOf(std::size_t series, const Theme& t) const {
  const FigureSeries& s = figure_.series[series];
  QColor colour = policyLook(s.policy, t).colour;
  const bool out = standsOut(series);
  if (!out) colour.setAlphaF(0.5f);
  QPen pen(colour, out ? 2.2 : 1);
  if (const QList<qreal> dash = dashOf(s.agent); !dash.isEmpty()) pen.setDashPattern(dash);
  pen.setJoinStyle(Qt::RoundJoin);
  return pen;
}

/// Names in the list leave out a group that is the same for all.
QString FigurePainter::listName(std::size_t series) const {
  const std::string& name = figure_.series[series].name;
  const bool one = std::all_of(figure_.series.begin(), figure_.series.end(),
                               [&](const FigureSeries& s) { return groupOf(s.name) == groupOf(name); });
  return one ? nameInGroup(name) : shownName(name);
}

double FigurePainter::listWidth(double most) const {
  if (singlePoints()) return 24;
  const QFontMetricsF metrics(textFont(11, 500));
  double widest = metrics.horizontalAdvance(QObject::tr("highest at the end first")) - kStroke;
  for (std::size_t i = 0; i < figure_.series.size(); ++i)
    widest = std::max(widest, metrics.horizontalAdvance(listName(i)));
  return std::min(most, 14 + kStroke + 6 + widest + 12);
}

QRectF FigurePainter::curvePlot(QSizeF size) const {
  const double line = QFontMetricsF(textFont(11)).height(), list = listWidth(std::max(90.0, 0.36 * size.width()));
  return {left(), top() + 2, std::max(40.0, size.width() - left() - list),
          std::max(40.0, size.height() - top() - 2 * line - 18)};
}

double FigurePainter::listTop(QSizeF size) const {
  return curvePlot(size).top() + (figure_.series.size() > 1 ? rowHeight() : 0);
}

// Series that stand out are always in the list.
std::vector<std::size_t> FigurePainter::listed(QSizeF size) const {
  const double room = size.height() - listTop(size) - 6;
  const auto rows = static_cast<std::size_t>(std::max(1.0, std::floor(room / rowHeight())));
  if (byEnd_.size() <= rows) return byEnd_;
  std::vector<std::size_t> list;
  const auto take = [&](bool out) {
    for (const std::size_t i : byEnd_)
      if (standsOut(i) == out && list.size() + 1 < rows) list.push_back(i);
  };
  take(true);
  take(false);
  std::sort(list.begin(), list.end(), [&](auto a, auto b) {
    return std::find(byEnd_.begin(), byEnd_.end(), a) < std::find(byEnd_.begin(), byEnd_.end(), b);
  });
  return list;
}

void FigurePainter::paintList(QPainter& p, const Theme& t, QSizeF size) const {
  const QRectF plot = curvePlot(size);
  const double x = plot.right() + 14, row = rowHeight(), width = size.width() - x - kStroke - 10;
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  const QString head = p.fontMetrics().elidedText(QObject::tr("highest at the end first"), Qt::ElideRight,
                                                  static_cast<int>(size.width() - x - 6));
  if (figure_.series.size() > 1) drawSymbol(p, QRectF(x, plot.top(), size.width() - x, row), Qt::AlignLeft, head);
  double y = listTop(size);
  const auto list = listed(size);
  for (const std::size_t i : list) {
    QPen pen = penOf(i, t);
    p.setPen(pen);
    p.drawLine(QPointF(x, y + row / 2), QPointF(x + kStroke, y + row / 2));
    drawMarker(p, {x + kStroke / 2, y + row / 2}, policyLook(figure_.series[i].policy, t), standsOut(i));
    p.setFont(textFont(11, standsOut(i) ? 500 : 400));
    p.setPen(standsOut(i) ? t.ink : t.quiet);
    const QString name = p.fontMetrics().elidedText(listName(i), Qt::ElideMiddle, static_cast<int>(width));
    drawSymbol(p, QRectF(x + kStroke + 6, y, width, row), Qt::AlignLeft, name);
    y += row;
  }
  if (list.size() == byEnd_.size()) return;
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  drawSymbol(p, QRectF(x, y, size.width() - x, row), Qt::AlignLeft,
             QObject::tr("… and %1 more").arg(byEnd_.size() - list.size()));
}

void FigurePainter::paintCurves(QPainter& p, const Theme& t, const QRectF& plot) const {
  p.save();
  p.setClipRect(plot.adjusted(-4, -4, 4, 8));
  for (const bool out : {false, true})  // series that stand out are drawn last, above the others
    for (std::size_t i = 0; i < figure_.series.size(); ++i)
      if (standsOut(i) == out) paintCurve(p, t, plot, i);
  p.restore();
}

void FigurePainter::paintCurve(QPainter& p, const Theme& t, const QRectF& plot, std::size_t series) const {
  const FigureSeries& s = figure_.series[series];
  if (s.x.empty()) return;
  const QPen pen = penOf(series, t);
  if (figure_.points) return paintPoint(p, t, plot, series);
  QPainterPath line(at(s.x[0], s.y[0].value, plot));
  QPolygonF band;
  for (std::size_t k = 0; k < s.x.size(); ++k) {
    line.lineTo(at(s.x[k], s.y[k].value, plot));
    if (known(s.y[k])) band << at(s.x[k], s.y[k].high, plot);
  }
  for (std::size_t k = s.x.size(); k-- > 0;)
    if (known(s.y[k])) band << at(s.x[k], s.y[k].low, plot);
  const bool points = singlePoints();
  QColor wash = pen.color();
  wash.setAlphaF(0.18f);
  p.setPen(Qt::NoPen);
  p.setBrush(wash);
  if (!points && standsOut(series)) {
    p.save();
    p.setClipRect(plot, Qt::IntersectClip);
    p.drawPolygon(band);
    p.restore();
  }
  p.setBrush(Qt::NoBrush);
  p.setPen(pen);
  p.save();
  p.setClipRect(plot.adjusted(-2, -2, 2, 2), Qt::IntersectClip);
  p.drawPath(line);
  p.restore();
  if (!points) paintBeyond(p, t, plot, series);
  for (std::size_t k = 0; points && k < s.x.size(); ++k) {
    p.setPen(QPen(pen.color(), 1.2));
    if (known(s.y[k])) p.drawLine(at(s.x[k], s.y[k].low, plot), at(s.x[k], s.y[k].high, plot));
    p.setBrush(pen.color());
    p.drawEllipse(at(s.x[k], s.y[k].value, plot), 3, 3);
    p.setBrush(Qt::NoBrush);
  }
}

/// A cross of both intervals, and the policy's marker where they meet.
void FigurePainter::paintPoint(QPainter& p, const Theme& t, const QRectF& plot, std::size_t series) const {
  const FigureSeries& s = figure_.series[series];
  const QPointF middle = at(s.x[0], s.y[0].value, plot);
  p.save();
  p.setClipRect(plot.adjusted(-2, -2, 2, 2), Qt::IntersectClip);
  p.setPen(QPen(penOf(series, t).color(), 1.2));
  if (known(s.y[0])) p.drawLine(at(s.x[0], s.y[0].low, plot), at(s.x[0], s.y[0].high, plot));
  if (known(s.spread[0])) p.drawLine(at(s.spread[0].low, s.y[0].value, plot), at(s.spread[0].high, s.y[0].value, plot));
  p.restore();
  drawMarker(p, middle, policyLook(s.policy, t), standsOut(series));
}

/// Where a curve, or the band of one that stands out, goes on beyond the axis: a triangle at the edge, in the middle of
/// that part.
void FigurePainter::paintBeyond(QPainter& p, const Theme& t, const QRectF& plot, std::size_t series) const {
  constexpr double kHalf = 3.5, kHigh = 5;
  const FigureSeries& s = figure_.series[series];
  const bool band = standsOut(series);
  for (const bool above : {true, false}) {
    double from = 0, to = -1;
    for (std::size_t k = 0; k < s.x.size(); ++k) {
      const Interval& v = s.y[k];
      const double y = band && known(v) ? (above ? v.high : v.low) : v.value;
      const double x = at(s.x[k], 0, plot).x();
      if (x < plot.left() || x > plot.right() || !(above ? y > yMost_ : y < yLeast_)) continue;
      if (to < from) from = x;
      to = x;
    }
    if (to < from) continue;
    const double x = std::clamp((from + to) / 2, plot.left() + kHalf, plot.right() - kHalf);
    const double edge = above ? plot.top() : plot.bottom(), tip = above ? edge - kHigh + 1 : edge + kHigh + 1;
    p.setPen(QPen(t.panel, 1));
    p.setBrush(penOf(series, t).color());
    p.drawPolygon(QPolygonF({{x - kHalf, edge + 1}, {x + kHalf, edge + 1}, {x, tip}}));
  }
  p.setBrush(Qt::NoBrush);
}

std::optional<std::size_t> FigurePainter::seriesAt(QPointF point, QSizeF size, double scroll) const {
  if (figure_.scene || figure_.series.empty()) return std::nullopt;
  if (figure_.bars) {
    const BarLayout l = barLayout(size);
    if (point.y() < l.plot.top() || point.x() < l.plot.left()) return std::nullopt;
    for (std::size_t place = 0; place < l.x.size(); ++place)
      if (std::abs(l.x[place] - scroll - point.x()) <= l.column / 2) return names_.order[place];
    return std::nullopt;
  }
  const QRectF plot = curvePlot(size);
  if (!plot.contains(point)) {
    const auto list = listed(size);
    const double row = std::floor((point.y() - listTop(size)) / rowHeight());
    const bool hit = !singlePoints() && point.x() > plot.right() && row >= 0 && row < static_cast<double>(list.size());
    return hit ? std::optional(list[static_cast<std::size_t>(row)]) : std::nullopt;
  }
  std::optional<std::size_t> best;
  double nearest = kNear;
  for (std::size_t i = 0; i < figure_.series.size(); ++i) {
    const auto k = placeAt(i, *timeAt(point, size));
    if (!k) continue;
    const double away = std::abs(yOf(figure_.series[i].y[*k].value, plot) - point.y());
    if (away < nearest) nearest = away, best = i;
  }
  return best;
}

}  // namespace surefoot
