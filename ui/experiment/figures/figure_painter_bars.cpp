// SPDX-License-Identifier: GPL-3.0-or-later
// Upright bars, in groups.
#include <algorithm>
#include <cmath>

#include "ui/experiment/figures/figure_painter.h"
#include "ui/style/policy_look.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/counted.h"

namespace surefoot {

namespace {

constexpr int kMostLabelLines = 3;
constexpr double kBar = 0.52, kWidestColumn = 8.5, kWidestBar = 2.5;  // share of a column; others: lines of text

QFontMetricsF small() {
  return QFontMetricsF(textFont(11));
}

/// A label in lines that are no wider than a column; the last line is cut if it is too long.
QStringList wrapped(const QString& label, double width) {
  QStringList lines;
  const QFontMetricsF metrics = small();
  for (const QString& word : label.split(' ', Qt::SkipEmptyParts)) {
    if (!lines.isEmpty() && metrics.horizontalAdvance(lines.back() + ' ' + word) <= width)
      lines.back() += ' ' + word;
    else
      lines << word;
  }
  if (lines.size() > kMostLabelLines) {
    lines[kMostLabelLines - 1] = QStringList(lines.mid(kMostLabelLines - 1)).join(' ');
    lines = lines.mid(0, kMostLabelLines);
  }
  for (QString& line : lines) line = metrics.elidedText(line, Qt::ElideRight, width);
  return lines;
}

/// A bracket's title, in the middle of its visible part.
void drawRunTitle(QPainter& p, const QString& title, double from, double to, const QRectF& seen, double y) {
  const double left = std::max(from, seen.left()), right = std::min(to, seen.right());
  if (right - left < 8) return;
  const QString text = p.fontMetrics().elidedText(title, Qt::ElideRight, static_cast<int>(right - left));
  drawSymbol(p, QRectF(left, y, right - left, p.fontMetrics().height()), Qt::AlignHCenter, text);
}

}  // namespace

/// Wide enough for the longest word below a bar, up to a limit.
double FigurePainter::smallestColumn() const {
  const QFontMetricsF metrics = small();
  double widest = 1.6 * metrics.height();
  for (const QString& label : names_.labels)
    for (const QString& word : label.split(' ')) widest = std::max(widest, metrics.horizontalAdvance(word));
  for (const FigureSeries& s : figure_.series)
    if (!s.complete()) widest = std::max(widest, metrics.horizontalAdvance(livesText(s.lives)));
  return std::min(widest, 6 * metrics.height()) + 10;
}

QStringList FigurePainter::barHead() const {
  const auto any = [&](auto has) { return std::any_of(figure_.series.begin(), figure_.series.end(), has); };
  QStringList head;
  if (any([](const FigureSeries& s) { return !s.marked.empty() && s.marked[0]; }))
    head << QObject::tr("✕ differs from the reference, p < .01");
  if (any([](const FigureSeries& s) { return s.thesis.has_value(); })) head << QObject::tr("◇ the thesis");
  if (any([](const FigureSeries& s) { return !s.complete(); }))
    head << QObject::tr("open bars: so far, lives are missing");
  return head;
}

/// Height of the legend above the bars (its lines wrap), with room for the marks of the highest bar.
double FigurePainter::headHeight(double width) const {
  const QFontMetricsF metrics = small();
  double x = 0;
  int lines = 1;
  for (const QString& part : barHead()) {
    const double w = metrics.horizontalAdvance(part) + 24;
    if (x > 0 && x + w > width) ++lines, x = 0;
    x += w;
  }
  return lines * metrics.height() + 6 + metrics.height() + 8;
}

FigurePainter::BarLayout FigurePainter::barLayout(QSizeF size) const {
  BarLayout l;
  const QFontMetricsF metrics = small();
  const double line = metrics.height(), n = static_cast<double>(std::max<std::size_t>(1, figure_.series.size()));
  const double width = size.width() - left() - 16;
  l.gap = names_.groups.size() > 1 ? line : 0;
  const double gaps = l.gap * static_cast<double>(std::max<std::size_t>(1, names_.groups.size()) - 1);
  l.column = std::clamp((width - gaps) / n, smallestColumn(), std::max(smallestColumn(), kWidestColumn * line));
  double x = left();
  for (std::size_t place = 0; place < figure_.series.size(); ++place) {
    const bool begins = std::any_of(names_.groups.begin(), names_.groups.end(),
                                    [&](const auto& g) { return place > 0 && g.first == place; });
    x += (begins ? l.gap : 0) + l.column;
    l.x.push_back(x - l.column / 2);
    l.labelLines = std::max(l.labelLines, static_cast<int>(wrapped(names_.labels[place], l.column - 6).size()));
  }
  l.whole = x - left();
  const bool open =
      std::any_of(figure_.series.begin(), figure_.series.end(), [](const auto& s) { return !s.complete(); });
  const double below =
      (l.labelLines + (open ? 1 : 0) + (names_.families.empty() ? 0 : 1) + (names_.groups.empty() ? 0 : 1)) * line + 16;
  const double above = top() + headHeight(width);
  l.plot = QRectF(left(), above, width, std::max(40.0, size.height() - above - below));
  return l;
}

double FigurePainter::mostScroll(QSizeF size) const {
  if (!figure_.bars || figure_.series.empty()) return 0;
  const BarLayout l = barLayout(size);
  return std::max(0.0, l.whole - l.plot.width());
}

void FigurePainter::paintBars(QPainter& p, const Theme& t, QSizeF size, double scroll) const {
  BarLayout l = barLayout(size);
  paintGrid(p, t, l.plot);
  paintYTitle(p, t, l.plot);
  paintBarHead(p, t, size);
  for (double& x : l.x) x -= scroll;
  p.save();
  p.setClipRect(QRectF(l.plot.left(), 0, l.plot.width(), size.height()));  // no bar leaves the axis
  paintReferences(p, t, l);
  for (std::size_t place = 0; place < l.x.size(); ++place)
    paintBar(p, t, l.plot, l.x[place], l.column, names_.order[place]);
  p.setClipRect(QRectF(l.plot.left(), 0, l.plot.width() + 12, size.height()));
  paintBarLabels(p, t, l);
  p.restore();
}

void FigurePainter::paintBar(QPainter& p, const Theme& t, const QRectF& plot, double x, double column,
                             std::size_t series) const {
  const FigureSeries& s = figure_.series[series];
  if (s.y.empty() || !std::isfinite(s.y[0].value)) return;
  const Interval& v = s.y[0];
  const double width = std::min(kBar * column, kWidestBar * small().height());
  const QColor colour = policyLook(s.policy, t).colour;
  QColor wash = colour;
  wash.setAlphaF(0.18f);
  const QRectF bar = QRectF(QPointF(x - width / 2, yOf(std::max(0.0, v.value), plot)),
                            QPointF(x + width / 2, yOf(std::min(0.0, v.value), plot)));
  p.setPen(s.complete() ? QPen(Qt::NoPen) : QPen(colour, 1.2));
  p.setBrush(s.complete() ? colour : wash);
  p.drawRect(s.complete() ? bar : bar.adjusted(0.5, 0.5, -0.5, 0));
  if (std::isfinite(v.low) && std::isfinite(v.high)) {
    const double cap = std::min(5.0, width / 3), high = std::max(yOf(v.high, plot), plot.top());
    const double low = std::min(yOf(v.low, plot), plot.bottom());
    // Ink outside the bar, the paper's colour inside.
    const auto whisker = [&](const QPen& pen) {
      p.setPen(pen);
      p.drawLine(QPointF(x, low), QPointF(x, high));
      // An end beyond the axis has no cap: an arrow says that it goes on.
      const auto arrow = [&](double end, double way) {
        p.drawLine(QPointF(x - cap, end + way), QPointF(x, end));
        p.drawLine(QPointF(x, end), QPointF(x + cap, end + way));
      };
      yOf(v.high, plot) < plot.top() - 1 ? arrow(high, cap)
                                         : p.drawLine(QPointF(x - cap, high), QPointF(x + cap, high));
      yOf(v.low, plot) > plot.bottom() + 1 ? arrow(low, -cap)
                                           : p.drawLine(QPointF(x - cap, low), QPointF(x + cap, low));
    };
    whisker(QPen(t.ink, 1.5));
    if (s.complete()) {
      p.save();
      p.setClipRect(bar, Qt::IntersectClip);
      whisker(QPen(t.panel, 1.5));
      p.restore();
    }
  }
  paintMarks(p, t, x, width, plot, series);
}

void FigurePainter::paintMarks(QPainter& p, const Theme& t, double x, double barWidth, const QRectF& plot,
                               std::size_t series) const {
  const FigureSeries& s = figure_.series[series];
  const double reach = std::isfinite(s.y[0].high) ? std::max(s.y[0].high, s.y[0].value) : s.y[0].value;
  const double above = std::max(yOf(std::max(0.0, reach), plot), plot.top()) - 0.8 * small().height();
  const double arm = 0.3 * small().height();
  if (!s.marked.empty() && s.marked[0]) {
    p.setPen(QPen(t.ink, 1.8));
    p.drawLine(QPointF(x - arm, above - arm), QPointF(x + arm, above + arm));
    p.drawLine(QPointF(x - arm, above + arm), QPointF(x + arm, above - arm));
  }
  if (!s.thesis) return;
  const QPointF c(x + barWidth / 2 + arm + 3, yOf(*s.thesis, plot));  // an open diamond beside the bar
  p.setPen(QPen(t.ink, 1.2));
  p.setBrush(t.panel);
  p.drawPolygon(QPolygonF{{c.x(), c.y() - arm}, {c.x() + arm, c.y()}, {c.x(), c.y() + arm}, {c.x() - arm, c.y()}});
}

/// A dashed line at the mean of every reference, over the bars that are compared with it.
void FigurePainter::paintReferences(QPainter& p, const Theme& t, const BarLayout& l) const {
  for (std::size_t place = 0; place < l.x.size(); ++place) {
    const FigureSeries& reference = figure_.series[names_.order[place]];
    if (reference.y.empty() || !std::isfinite(reference.y[0].value)) continue;
    std::size_t first = place, last = place;
    for (std::size_t other = 0; other < l.x.size(); ++other)
      if (figure_.series[names_.order[other]].reference == reference.name)
        first = std::min(first, other), last = std::max(last, other);
    if (first == last) continue;
    const double y = std::round(yOf(reference.y[0].value, l.plot)) + 0.5;
    p.setPen(QPen(t.ink, 1, Qt::CustomDashLine));
    QPen pen = p.pen();
    pen.setDashPattern({3, 3});
    p.setPen(pen);
    p.drawLine(QPointF(l.x[first] - l.column / 2, y), QPointF(l.x[last] + l.column / 2, y));
  }
}

void FigurePainter::paintBarLabels(QPainter& p, const Theme& t, const BarLayout& l) const {
  const double line = small().height();
  double y = l.plot.bottom() + 6;
  bool open = false;
  for (std::size_t place = 0; place < l.x.size(); ++place) {
    const FigureSeries& s = figure_.series[names_.order[place]];
    p.setFont(textFont(11, s.name == chosen_ ? 500 : 400));
    p.setPen(t.ink);
    open = open || !s.complete();
    const QRectF seen = l.plot.adjusted(0, 0, 12, 0);  // a label that would be cut comes with the scroll bar
    if (l.x[place] - l.column / 2 < seen.left() - 3 || l.x[place] + l.column / 2 > seen.right() + 3) continue;
    double below = y;
    for (const QString& text : wrapped(names_.labels[place], l.column - 6)) {
      drawSymbol(p, QRectF(l.x[place] - l.column / 2, below, l.column, line), Qt::AlignHCenter, text);
      below += line;
    }
    if (s.complete()) continue;
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(l.x[place] - l.column / 2, y + l.labelLines * line, l.column, line), Qt::AlignHCenter,
               livesText(s.lives));
  }
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  y += (l.labelLines + (open ? 1 : 0)) * line;
  const auto runs = [&](const std::vector<NameGroups::Run>& all, bool ruled) {
    for (const auto& run : all) {
      const double from = l.x[run.first] - l.column / 2, to = l.x[run.last] + l.column / 2;
      p.setPen(QPen(t.outline, 1));
      if (ruled) p.drawLine(QPointF(from + 4, std::round(y) + 2.5), QPointF(to - 4, std::round(y) + 2.5));
      p.setPen(t.quiet);
      drawRunTitle(p, run.title, from, to, l.plot.adjusted(0, 0, 12, 0), y + (ruled ? 4 : 0));
    }
  };
  runs(names_.families, false);
  if (!names_.families.empty()) y += line;
  runs(names_.groups, true);
}

void FigurePainter::paintBarHead(QPainter& p, const Theme& t, QSizeF size) const {
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  const double width = size.width() - left() - 16;
  double x = 0, y = top();
  for (const QString& part : barHead()) {
    const double w = small().horizontalAdvance(part) + 24;
    if (x > 0 && x + w > width) x = 0, y += small().height();
    drawSymbol(p, QRectF(left() + x, y, w, small().height()), Qt::AlignLeft, part);
    x += w;
  }
}

}  // namespace surefoot
