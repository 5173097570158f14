// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure_view.h"

#include <QPaintEvent>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.h"
#include "ui/learning_charts.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

namespace {

constexpr double kLeft = FigureView::kLeft, kBottom = FigureView::kBottom, kLegend = 190;  // gutters [px]
constexpr double kRow = 22, kBarLabels = 210;                                              // of bars [px]

/// A value on an axis whose ticks are so far apart.
QString tickText(double value, double step) {
  return toText(step < 0.01  ? fixedText(value, 3)
                : step < 0.1 ? fixedText(value, 2)
                : step < 1   ? fixedText(value, 1)
                             : countText(value));
}

}  // namespace

FigureView::FigureView(Figure figure, QWidget* parent) : QWidget(parent), figure_(std::move(figure)) {
  chooseRanges();
  setAccessibleName(toText(figure_.title));
}

QSize FigureView::sizeHint() const {
  if (!figure_.bars) return {760, 420};
  return {760, static_cast<int>(top() + kBottom + kRow * static_cast<double>(figure_.series.size()))};
}

void FigureView::setFigure(Figure figure, const QString& words) {
  figure_ = std::move(figure);
  words_ = words;
  xLeast_ = yLeast_ = 0;
  xMost_ = yMost_ = 1;
  chooseRanges();
  setAccessibleName(figure_.title.empty() ? words : toText(figure_.title));
  update();
}

double FigureView::rowHeight() const {
  const double rows = std::max<double>(1, static_cast<double>(figure_.series.size()));
  return std::clamp((height() - top() - kBottom) / rows, 10.0, 1.5 * kRow);
}

void FigureView::chooseRanges() {
  const double huge = std::numeric_limits<double>::max();
  double low = figure_.bars ? 0 : huge, high = figure_.bars ? 0 : -huge, right = 0;
  xLeast_ = figure_.series.empty() || figure_.series[0].x.empty() ? 0 : std::min(0.0, figure_.series[0].x[0]);
  for (const FigureSeries& s : figure_.series)
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      right = std::max(right, s.x[i]);
      // Bands of two or three lives would squeeze everything else.
      if (std::isfinite(s.y[i].value)) low = std::min(low, s.y[i].value), high = std::max(high, s.y[i].value);
      if (figure_.bars && std::isfinite(s.y[i].high)) high = std::max(high, s.y[i].high);
      if (figure_.bars && std::isfinite(s.y[i].low)) low = std::min(low, s.y[i].low);
      if (s.thesis) low = std::min(low, *s.thesis), high = std::max(high, *s.thesis);
    }
  if (low > high) low = 0, high = 1;  // nothing to show
  if (low > 0 && low < 0.5 * high) low = 0;
  const double step = niceAbove(std::max(high - low, 1e-9) / 6);
  yLeast_ = std::floor(low / step) * step;
  yMost_ = std::ceil(high / step * 1.0001) * step;
  xMost_ = right > xLeast_ ? right : xLeast_ + 1;
}

QPointF FigureView::at(double x, double y, const QRectF& plot) const {
  return {plot.left() + (x - xLeast_) / (xMost_ - xLeast_) * plot.width(),
          plot.bottom() - (y - yLeast_) / (yMost_ - yLeast_) * plot.height()};
}

void FigureView::setChosen(const std::string& series) {
  chosen_ = series;
  update();
}

bool FigureView::standsOut(std::size_t series) const {
  const auto named = [&](const FigureSeries& s) { return s.name == chosen_; };
  const bool any = std::any_of(figure_.series.begin(), figure_.series.end(), named);
  return !any || series == 0 || named(figure_.series[series]);
}

// Curves of one policy are told apart by lightness and dashes.
QPen FigureView::penOf(std::size_t series, const Theme& t) const {
  const FigureSeries& s = figure_.series[series];
  int before = 0, all = 0;
  for (std::size_t i = 0; i < figure_.series.size(); ++i) {
    if (figure_.series[i].policy != s.policy) continue;
    before += i < series;
    ++all;
  }
  QColor colour = policyLook(s.policy, t).colour;
  if (all > 1) {
    const double part = 1.1 * before / (all - 1) - 0.6;  // −0.6: towards the ink … 0.5: towards the paper
    const QColor& other = part < 0 ? t.ink : t.panel;
    const auto mix = [&](int a, int b) { return static_cast<int>(a + std::abs(part) * (b - a)); };
    colour =
        QColor(mix(colour.red(), other.red()), mix(colour.green(), other.green()), mix(colour.blue(), other.blue()));
  }
  const bool out = standsOut(series);
  if (!out) colour.setAlphaF(0.5f);
  QPen pen(colour, !out ? 1 : chosen_.empty() ? 1.6 : 2.2);
  static const QList<qreal> kDashes[] = {{}, {6, 3}, {2, 2}, {8, 3, 2, 3}};
  if (!kDashes[before % 4].isEmpty()) pen.setDashPattern(kDashes[before % 4]);
  pen.setJoinStyle(Qt::RoundJoin);
  return pen;
}

void FigureView::paintEvent(QPaintEvent*) {
  QPainter p(this);
  paint(p, themeOf(*this));
}

void FigureView::paint(QPainter& p, const Theme& t) const {
  p.setRenderHint(QPainter::Antialiasing);
  p.fillRect(rect(), t.panel);
  if (!words_.isEmpty()) {
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    p.drawText(rect(), Qt::AlignCenter, words_);
    return;
  }
  p.setFont(textFont(13, 500));
  p.setPen(t.ink);
  if (titleShown_) drawSymbol(p, QRectF(16, 8, width() - 32, 20), Qt::AlignLeft, toText(figure_.title));
  if (figure_.scene) return paintScene(p, t);
  if (figure_.bars) return paintBars(p, t);
  const QRectF plot(kLeft, top(), width() - kLeft - kLegend, height() - top() - kBottom);
  paintAxes(p, t, plot);
  paintCurves(p, t, plot);
  paintLegend(p, t, plot);
}

void FigureView::paintAxes(QPainter& p, const Theme& t, const QRectF& plot) const {
  p.setFont(textFont(11));
  const double yStep = niceAbove((yMost_ - yLeast_) / 6.0001);
  for (double y = std::ceil(yLeast_ / yStep - 1e-9) * yStep; y <= yMost_ + 1e-9; y += yStep) {
    const double line = std::round(at(0, y, plot).y()) + 0.5;
    p.setPen(QPen(t.hairline, 1));
    p.drawLine(QPointF(plot.left(), line), QPointF(plot.right(), line));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(plot.left() - 56, line - 8, 48, 16), Qt::AlignRight, tickText(y, yStep));
  }
  const double base = std::round(plot.bottom()) + 0.5;
  p.setPen(QPen(t.outline, 1));
  p.drawLine(QPointF(plot.left(), base), QPointF(plot.right(), base));
  const double xStep = niceAbove((xMost_ - xLeast_) / 8.0001);
  for (double x = std::ceil(xLeast_ / xStep - 1e-9) * xStep; x <= xMost_ + 1e-9; x += xStep) {
    const double tick = at(x, 0, plot).x();
    p.setPen(QPen(t.outline, 1));
    p.drawLine(QPointF(tick, base), QPointF(tick, base + 4));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(tick - 30, base + 5, 60, 16), Qt::AlignHCenter, tickText(x, xStep));
  }
  paintTitles(p, t, plot);
}

void FigureView::paintTitles(QPainter& p, const Theme& t, const QRectF& plot) const {
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  drawSymbol(p, QRectF(plot.left(), plot.bottom() + 22, plot.width(), 16), Qt::AlignHCenter, toText(figure_.xTitle));
  p.save();
  p.translate(14, plot.center().y());
  p.rotate(-90);
  p.drawText(QRectF(-plot.height() / 2, -8, plot.height(), 16), Qt::AlignCenter, toText(figure_.yTitle));
  p.restore();
}

void FigureView::paintCurves(QPainter& p, const Theme& t, const QRectF& plot) const {
  p.save();
  p.setClipRect(plot.adjusted(-4, -4, 4, 4));
  const bool points = figure_.series.size() == 1 && figure_.series[0].x.size() < 30;
  for (std::size_t i = 0; i < figure_.series.size(); ++i) {
    const FigureSeries& s = figure_.series[i];
    if (s.x.empty()) continue;
    const QPen pen = penOf(i, t);
    QPainterPath line(at(s.x[0], s.y[0].value, plot));
    QPolygonF band;
    for (std::size_t k = 0; k < s.x.size(); ++k) {
      line.lineTo(at(s.x[k], s.y[k].value, plot));
      if (s.y[k].known()) band << at(s.x[k], s.y[k].high, plot);
    }
    for (std::size_t k = s.x.size(); k-- > 0;)
      if (s.y[k].known()) band << at(s.x[k], s.y[k].low, plot);
    QColor wash = pen.color();
    wash.setAlphaF(0.10f);
    p.setPen(Qt::NoPen);
    p.setBrush(wash);
    if (!points && standsOut(i)) p.drawPolygon(band);
    p.setBrush(Qt::NoBrush);
    p.setPen(pen);
    p.drawPath(line);
    if (!points) continue;
    for (std::size_t k = 0; k < s.x.size(); ++k) {
      p.setPen(QPen(pen.color(), 1.2));
      if (s.y[k].known()) p.drawLine(at(s.x[k], s.y[k].low, plot), at(s.x[k], s.y[k].high, plot));
      p.setBrush(pen.color());
      p.drawEllipse(at(s.x[k], s.y[k].value, plot), 3, 3);
      p.setBrush(Qt::NoBrush);
    }
  }
  p.restore();
}

void FigureView::paintLegend(QPainter& p, const Theme& t, const QRectF& plot) const {
  if (figure_.series.size() == 1 && !figure_.series[0].x.empty() && figure_.series[0].x.size() < 30) return;
  p.setFont(textFont(11));
  double y = plot.top();
  for (std::size_t i = 0; i < figure_.series.size(); ++i, y += 18) {
    p.setPen(penOf(i, t));
    p.drawLine(QPointF(plot.right() + 14, y + 8), QPointF(plot.right() + 40, y + 8));
    p.setPen(t.ink);
    const QString name =
        p.fontMetrics().elidedText(toText(figure_.series[i].name), Qt::ElideMiddle, static_cast<int>(kLegend) - 56);
    drawSymbol(p, QRectF(plot.right() + 46, y, kLegend - 50, 16), Qt::AlignLeft, name);
  }
}

void FigureView::paintBars(QPainter& p, const Theme& t) const {
  const double row = rowHeight();
  const double labels = std::min(kBarLabels, 0.36 * width());
  const QRectF plot(labels, top(), width() - labels - 90, row * static_cast<double>(figure_.series.size()));
  const auto xOf = [&](double value) { return plot.left() + (value - yLeast_) / (yMost_ - yLeast_) * plot.width(); };
  p.setFont(textFont(11));
  const double step = niceAbove((yMost_ - yLeast_) / 6.0001);
  for (double v = std::ceil(yLeast_ / step - 1e-9) * step; v <= yMost_ + 1e-9; v += step) {
    const double x = std::round(xOf(v)) + 0.5;
    p.setPen(QPen(t.hairline, 1));
    p.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(x - 30, plot.bottom() + 4, 60, 16), Qt::AlignHCenter, tickText(v, step));
  }
  p.drawText(QRectF(plot.left(), plot.bottom() + 22, plot.width(), 16), Qt::AlignCenter, toText(figure_.yTitle));
  bool anyThesis = false;
  for (std::size_t i = 0; i < figure_.series.size(); ++i) {
    const FigureSeries& s = figure_.series[i];
    const double y = plot.top() + row * static_cast<double>(i), middle = y + row / 2;
    const Interval& v = s.y[0];
    p.setPen(t.ink);
    drawSymbol(p, QRectF(16, y, labels - 26, row), Qt::AlignRight,
               p.fontMetrics().elidedText(toText(s.name), Qt::ElideMiddle, static_cast<int>(labels) - 26));
    if (!std::isfinite(v.value)) continue;
    p.setPen(Qt::NoPen);
    QColor fill = policyLook(s.policy, t).colour;
    if (!standsOut(i)) fill.setAlphaF(0.45f);
    p.setBrush(fill);
    p.drawRect(QRectF(QPointF(xOf(std::min(0.0, v.value)), y + std::min(5.0, row / 5)),
                      QPointF(xOf(std::max(0.0, v.value)), y + row - std::min(5.0, row / 5))));
    // A casing, so that the interval is seen on the bar, too.
    for (const QPen& pen : {QPen(t.panel, 3.4), QPen(t.ink, 1.2)}) {
      if (!v.known()) break;
      p.setPen(pen);
      p.drawLine(QPointF(xOf(v.low), middle), QPointF(xOf(v.high), middle));
      for (const double end : {v.low, v.high}) p.drawLine(QPointF(xOf(end), middle - 3), QPointF(xOf(end), middle + 3));
    }
    if (s.thesis) {  // an open diamond
      const double x = xOf(*s.thesis);
      p.setPen(QPen(t.ink, 1.2));
      p.setBrush(t.panel);
      p.drawPolygon(QPolygonF{{x, middle - 5}, {x + 5, middle}, {x, middle + 5}, {x - 5, middle}});
      anyThesis = true;
    }
    QString text = toText(std::abs(v.value) < 10 ? fixedText(v.value, 2) : fixedText(v.value, 1));
    if (!s.marked.empty() && s.marked[0]) text += QStringLiteral("  X");
    const double end = v.known() ? v.high : std::max(0.0, v.value);
    const double after = std::max(xOf(end), s.thesis ? xOf(*s.thesis) + 5 : 0.0);
    p.setPen(t.ink);
    drawSymbol(p, QRectF(after + 8, y, 90, row), Qt::AlignLeft, text);
  }
  if (anyThesis) {
    p.setPen(t.quiet);
    p.drawText(QRectF(0, plot.bottom() + 22, width() - 16, 16), Qt::AlignRight, tr("◇ the thesis's"));
  }
}

}  // namespace surefoot
