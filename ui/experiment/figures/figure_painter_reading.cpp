// SPDX-License-Identifier: GPL-3.0-or-later
// The part of FigurePainter for the time axis of curves: the range that is shown, and the values at a time.
#include <algorithm>
#include <cmath>

#include "ui/experiment/figures/figure_painter.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {
constexpr std::size_t kMostRead = 8;  // values in the box
constexpr double kLeastPart = 1e-3;   // the smallest share of the time axis that is shown
}  // namespace

QString intervalText(const Interval& v) {
  const auto number = [](double x) { return fixedNumber(x, std::abs(x) < 10 ? 2 : 1); };
  const bool known = std::isfinite(v.low) && std::isfinite(v.high) && v.low < v.high;
  return number(v.value) + (known ? QObject::tr(" (95 %: %1 … %2)").arg(number(v.low), number(v.high)) : QString());
}

void FigurePainter::setTime(std::optional<std::pair<double, double>> part) {
  xLeast_ = xFirst_, xMost_ = xLast_;
  if (!part || figure_.bars || figure_.scene) return;
  const double whole = xLast_ - xFirst_;
  const double length = std::clamp(part->second - part->first, kLeastPart * whole, whole);
  xLeast_ = std::clamp(part->first, xFirst_, xLast_ - length);
  xMost_ = xLeast_ + length;
}

std::optional<double> FigurePainter::timeAt(QPointF point, QSizeF size) const {
  if (figure_.bars || figure_.scene || figure_.series.empty()) return std::nullopt;
  const QRectF plot = curvePlot(size);
  if (!plot.contains(point)) return std::nullopt;
  return xLeast_ + (point.x() - plot.left()) / plot.width() * (xMost_ - xLeast_);
}

std::optional<std::size_t> FigurePainter::placeAt(std::size_t series, double time) const {
  const std::vector<double>& x = figure_.series[series].x;
  const auto after = std::upper_bound(x.begin(), x.end(), time);
  return after == x.begin() ? std::nullopt : std::optional(static_cast<std::size_t>(after - x.begin()) - 1);
}

void FigurePainter::paintReading(QPainter& p, const Theme& t, QSizeF size) const {
  const auto time = reading_ ? timeAt(*reading_, size) : std::nullopt;
  if (!time) return;
  const QRectF plot = curvePlot(size);
  const double x = std::round(reading_->x()) + 0.5;
  p.setPen(QPen(t.quiet, 1));
  p.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
  const auto nearest = seriesAt(*reading_, size);
  std::vector<std::size_t> read;
  for (const std::size_t i : byEnd_)
    if (placeAt(i, *time) && (i == nearest || (standsOut(i) && read.size() + 1 < kMostRead))) read.push_back(i);
  if (read.empty()) return;
  // The box stands beside the line, on the side with more room.
  p.setFont(textFont(11));
  const double row = QFontMetricsF(p.font()).height() + 2, stroke = 14;
  std::vector<QString> texts;
  double widest = 0;
  for (const std::size_t i : read) {
    texts.push_back(listName(i) + QStringLiteral("  ") + intervalText(figure_.series[i].y[*placeAt(i, *time)]));
    widest = std::max(widest, symbolWidth(p.font(), texts.back()));
  }
  const QString head =
      QStringLiteral("%1: %2").arg(fromCore(figure_.xTitle), fixedNumber(*time, xMost_ - xLeast_ < 20 ? 2 : 0));
  widest = std::max(widest + stroke, symbolWidth(p.font(), head));
  const QSizeF box(std::min(widest + 16, plot.width()), row * static_cast<double>(read.size() + 1) + 8);
  const bool right = x < plot.center().x();
  const QRectF where(
      QPointF(right ? std::min(x + 8, plot.right() - box.width()) : std::max(x - 8 - box.width(), plot.left()),
              std::max(plot.top(), plot.bottom() - 6 - box.height())),
      box);
  QColor ground = t.panel;
  ground.setAlphaF(0.92f);
  p.setPen(QPen(t.hairline, 1));
  p.setBrush(ground);
  p.drawRect(where);
  p.setPen(t.quiet);
  drawSymbol(p, QRectF(where.left() + 8, where.top() + 4, box.width() - 16, row), Qt::AlignLeft, head);
  for (std::size_t k = 0; k < read.size(); ++k) {
    const double y = where.top() + 4 + row * static_cast<double>(k + 1);
    p.setPen(penOf(read[k], t));
    p.drawLine(QPointF(where.left() + 8, y + row / 2), QPointF(where.left() + 8 + stroke - 4, y + row / 2));
    p.setPen(read[k] == nearest ? t.ink : t.quiet);
    const double room = box.width() - 16 - stroke;
    drawSymbol(p, QRectF(where.left() + 8 + stroke, y, room, row), Qt::AlignLeft,
               p.fontMetrics().elidedText(texts[k], Qt::ElideMiddle, static_cast<int>(std::ceil(room))));
  }
}

}  // namespace surefoot
