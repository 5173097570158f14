// SPDX-License-Identifier: GPL-3.0-or-later
// The parts that all figures have: ranges, axes, titles, and the choice of the series that stand out.
#include "ui/experiment/figures/figure_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/text/text.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/style/round_numbers.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/counted.h"

namespace surefoot {

namespace {

constexpr std::size_t kFew = 3;  // up to this number, all curves are drawn in full

/// A value on an axis; `step` is the distance between two ticks.
QString tickText(double value, double step) {
  return localNumbers(step < 0.01  ? fixedText(value, 3)
                      : step < 0.1 ? fixedText(value, 2)
                      : step < 1   ? fixedText(value, 1)
                                   : countText(value));
}

double lineHeight() {
  return QFontMetricsF(textFont(11)).height();
}

double yStepOf(double low, double high) {
  return niceAbove((high - low) / 6.0001);
}

}  // namespace

FigurePainter::FigurePainter(Figure figure) : figure_(std::move(figure)) {
  std::vector<std::string> names;
  for (const FigureSeries& s : figure_.series) names.push_back(s.name);
  names_ = groupNames(names);
  byEnd_.resize(names.size());
  std::iota(byEnd_.begin(), byEnd_.end(), std::size_t{0});
  const auto end = [&](std::size_t i) {
    const auto& y = figure_.series[i].y;
    return y.empty() || !std::isfinite(y.back().value) ? -1e300 : y.back().value;
  };
  std::stable_sort(byEnd_.begin(), byEnd_.end(), [&](auto a, auto b) { return end(a) > end(b); });
  chooseRanges();
}

void FigurePainter::chooseRanges() {
  const double huge = std::numeric_limits<double>::max();
  double low = figure_.bars ? 0 : huge, high = figure_.bars ? 0 : -huge, right = 0;
  const auto include = [&](double v) {
    if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  };
  xLeast_ = figure_.series.empty() || figure_.series[0].x.empty() ? 0 : std::min(0.0, figure_.series[0].x[0]);
  for (const FigureSeries& s : figure_.series)
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      right = std::max(right, s.x[i]);
      include(s.y[i].value);
      if (s.thesis) include(*s.thesis);
    }
  if (!figure_.bars) leaveOutBeginning(right, low, high);
  // Intervals of two or three lives would squeeze everything else: they make the axis half as long again at the most.
  const double longest = 0.5 * std::max(high, -low);
  double lower = low, upper = high;
  for (const FigureSeries& s : figure_.series)
    for (const Interval& v : s.y) {
      if (!figure_.bars || !std::isfinite(v.low) || !std::isfinite(v.high)) continue;
      const bool few = s.planned > 0 && s.lives <= 3;
      lower = std::min(lower, few ? std::max(v.low, low - longest) : v.low);
      upper = std::max(upper, few ? std::min(v.high, high + longest) : v.high);
    }
  low = lower, high = upper;
  if (low > high) low = 0, high = 1;  // nothing to show
  const auto below = [](const FigureSeries& s) {
    return std::any_of(s.y.begin(), s.y.end(), [](const Interval& v) { return v.value < 0; });
  };
  // An interval of falls may reach below 0, where no falls are.
  if (low < 0 && std::none_of(figure_.series.begin(), figure_.series.end(), below)) low = 0;
  if (low > 0 && low < 0.5 * high) low = 0;
  const double step = niceAbove(std::max(high - low, 1e-9) / 6);
  yLeast_ = std::floor(low / step) * step;
  yMost_ = std::ceil(high / step - 1e-9) * step;
  if (yMost_ <= yLeast_) yMost_ = yLeast_ + step;
  xMost_ = right > xLeast_ ? right : xLeast_ + 1;
  xFirst_ = xLeast_, xLast_ = xMost_;
}

// The first episodes of a curve may be so far below all others that nothing else could be seen: then the axis is that
// of what comes after a tenth of it, and marks say where a curve leaves it.
void FigurePainter::leaveOutBeginning(double right, double& low, double& high) const {
  constexpr double kBeginning = 0.1, kSmall = 0.25;
  double least = high, most = low;
  for (const FigureSeries& s : figure_.series)
    for (std::size_t i = 0; i < s.x.size(); ++i)
      if (std::isfinite(s.y[i].value) && s.x[i] > xLeast_ + kBeginning * (right - xLeast_))
        least = std::min(least, s.y[i].value), most = std::max(most, s.y[i].value);
  if (least < most && most - least < kSmall * (high - low)) low = least, high = most;
}

QPointF FigurePainter::at(double x, double y, const QRectF& plot) const {
  return {plot.left() + (x - xLeast_) / (xMost_ - xLeast_) * plot.width(),
          plot.bottom() - (y - yLeast_) / (yMost_ - yLeast_) * plot.height()};
}

bool FigurePainter::isReference(std::size_t series) const {
  const std::string& name = figure_.series[series].name;
  return std::any_of(figure_.series.begin(), figure_.series.end(),
                     [&](const FigureSeries& s) { return s.reference == name && s.name != name; });
}

// If a condition is chosen: it and its reference. Else the references, or all series if there are few.
bool FigurePainter::standsOut(std::size_t series) const {
  const auto chosen = std::find_if(figure_.series.begin(), figure_.series.end(),
                                   [&](const FigureSeries& s) { return s.name == chosen_; });
  const std::string& name = figure_.series[series].name;
  if (chosen != figure_.series.end())
    return name == chosen_ || (chosen->reference.empty() ? false : name == chosen->reference);
  return figure_.series.size() <= kFew || isReference(series);
}

bool FigurePainter::singlePoints() const {
  return figure_.series.size() == 1 && figure_.series[0].x.size() < 30;
}

double FigurePainter::top() const {
  return titleShown_ ? QFontMetricsF(textFont(13, 500)).height() + 20 : 10;
}

/// Room for the y axis: its title, upright, and the widest of its numbers.
double FigurePainter::left() const {
  const QFontMetricsF metrics(textFont(11));
  const double step = yStepOf(yLeast_, yMost_);
  double widest = 0;
  for (double y = std::ceil(yLeast_ / step - 1e-9) * step; y <= yMost_ + 1e-9; y += step)
    widest = std::max(widest, metrics.horizontalAdvance(tickText(y, step)));
  return 10 + lineHeight() + 6 + widest + 8;
}

QSizeF FigurePainter::fullSize() const {
  if (figure_.scene) return {760, 420};
  const double line = lineHeight();
  if (figure_.bars) {
    const double groups = static_cast<double>(std::max<std::size_t>(1, names_.groups.size()) - 1);
    const double whole = smallestColumn() * static_cast<double>(figure_.series.size()) + groups * line;
    return {std::max(760.0, left() + whole + 16), std::max(440.0, 30 * line)};
  }
  const double rows = static_cast<double>(figure_.series.size()) + 2;
  return {std::max(560.0, 40 * line) + listWidth(1e9), std::max(420.0, top() + rows * (line + 3) + 4 * line)};
}

void FigurePainter::paint(QPainter& p, const Theme& t, QSizeF size, double scroll) const {
  p.setRenderHint(QPainter::Antialiasing);
  p.fillRect(QRectF(QPointF(0, 0), size), t.panel);
  p.setFont(textFont(13, 500));
  p.setPen(t.ink);
  if (titleShown_)
    drawSymbol(p, QRectF(16, 8, size.width() - 32, QFontMetricsF(p.font()).height()), Qt::AlignLeft,
               shownName(fromCore(figure_.title).toStdString()));
  if (figure_.scene) return paintScene(p, t, size);
  if (figure_.bars) return paintBars(p, t, size, scroll);
  const QRectF plot = curvePlot(size);
  paintGrid(p, t, plot);
  paintTimeAxis(p, t, plot);
  paintYTitle(p, t, plot);
  paintCurves(p, t, plot);
  paintReading(p, t, size);
  if (!singlePoints()) paintList(p, t, size);
}

void FigurePainter::paintGrid(QPainter& p, const Theme& t, const QRectF& plot) const {
  p.setFont(textFont(11));
  const double step = yStepOf(yLeast_, yMost_), line = lineHeight();
  for (double y = std::ceil(yLeast_ / step - 1e-9) * step; y <= yMost_ + 1e-9; y += step) {
    const double here = std::round(yOf(y, plot)) + 0.5;
    p.setPen(QPen(std::abs(y) < 1e-9 ? t.outline : t.hairline, 1));
    p.drawLine(QPointF(plot.left(), here), QPointF(plot.right(), here));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(0, here - line / 2, plot.left() - 8, line), Qt::AlignRight, tickText(y, step));
  }
}

void FigurePainter::paintTimeAxis(QPainter& p, const Theme& t, const QRectF& plot) const {
  p.setFont(textFont(11));
  const double base = std::round(plot.bottom()) + 0.5, line = lineHeight();
  p.setPen(QPen(t.outline, 1));
  p.drawLine(QPointF(plot.left(), base), QPointF(plot.right(), base));
  const double widest = p.fontMetrics().horizontalAdvance(tickText(xMost_, niceAbove((xMost_ - xLeast_) / 8.0001)));
  const double most = std::clamp(plot.width() / (widest + 16), 2.0, 8.0001);
  const double step = niceAbove((xMost_ - xLeast_) / most);
  for (double x = std::ceil(xLeast_ / step - 1e-9) * step; x <= xMost_ + 1e-9; x += step) {
    const double tick = at(x, 0, plot).x();
    p.setPen(QPen(t.outline, 1));
    p.drawLine(QPointF(tick, base), QPointF(tick, base + 4));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(tick - 60, base + 5, 120, line), Qt::AlignHCenter, tickText(x, step));
  }
  drawSymbol(p, QRectF(plot.left(), base + 8 + line, plot.width(), line), Qt::AlignHCenter, fromCore(figure_.xTitle));
}

void FigurePainter::paintYTitle(QPainter& p, const Theme& t, const QRectF& plot) const {
  p.save();
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  p.translate(10 + lineHeight() / 2, plot.center().y());
  p.rotate(-90);
  const double room = plot.height() + 2 * std::min(plot.top(), 40.0);
  const QString title = p.fontMetrics().elidedText(fromCore(figure_.yTitle), Qt::ElideRight, static_cast<int>(room));
  p.drawText(QRectF(-room / 2, -lineHeight() / 2, room, lineHeight()), Qt::AlignCenter, title);
  p.restore();
}

QString FigurePainter::textAt(QPointF point, QSizeF size, double scroll) const {
  const auto hit = seriesAt(point, size, scroll);
  if (!hit) return {};
  const FigureSeries& s = figure_.series[*hit];
  QString text = shownName(s.name);
  const auto time = timeAt(point, size);
  const auto k = figure_.bars ? std::optional<std::size_t>(0) : time ? placeAt(*hit, *time) : std::nullopt;
  if (k && *k < s.y.size() && std::isfinite(s.y[*k].value)) text += QStringLiteral(": ") + intervalText(s.y[*k]);
  if (s.thesis) text += QObject::tr(", thesis %1").arg(intervalText({*s.thesis, NAN, NAN}));
  if (s.planned > 0)
    text += s.complete()
                ? QStringLiteral(", ") + livesText(s.lives)
                : QObject::tr(", %1 of %2 lives so far", nullptr, forms(s.planned)).arg(s.lives).arg(s.planned);
  return text;
}

}  // namespace surefoot
