// SPDX-License-Identifier: GPL-3.0-or-later
// The curves and bars of strips: those of the first, and behind them the second's.
#include <algorithm>
#include <cmath>

#include "core/signals/strides.h"
#include "ui/live/signals/strip_painter.h"
#include "ui/style/theme.h"

namespace surefoot {

void StripPainter::drawStrip(QPainter& p, const StripSignals& strip, const QRectF& where, const Range& range) const {
  if (strip.look != StripLook::OnOff) drawAxis(p, where, range);
  p.save();
  p.setClipRect(where.adjusted(0, -2, 0, 2));
  if (second()) drawSecond(p, strip, where, range);
  if (strip.look == StripLook::OnOff)
    drawOnOff(p, first(), strip, where);
  else if (strip.look == StripLook::Bars || strip.look == StripLook::Stacked)
    drawBars(p, strip, where, range);
  else
    for (std::size_t s = strip.places.size(); s-- > 0;) {
      p.setPen(QPen(colourOf(strip, s), s == 0 ? 1.5 : 1.1));
      drawCurve(p, first(), picture_.table->columns()[strip.places[s]], where, range, strip.look);
    }
  p.restore();
}

/// Bars of a second would hide those of the first: a line has their values, of stacked ones their sum.
void StripPainter::drawSecond(QPainter& p, const StripSignals& strip, const QRectF& where, const Range& range) const {
  const Life life = *second();
  if (strip.look == StripLook::OnOff) return drawOnOff(p, life, strip, where);
  const StripLook look = strip.look == StripLook::Steps ? StripLook::Steps : StripLook::Lines;
  if (strip.look == StripLook::Stacked) {
    std::vector<double> sum(life.table.rows(), 0.0);
    for (const std::size_t place : strip.places)
      if (const auto* column = columnOf(life, place))
        for (std::size_t row = 0; row < sum.size(); ++row) sum[row] += (*column)[row];
    p.setPen(secondPen(theme_.ink));
    return drawCurve(p, life, sum, where, range, look);
  }
  for (std::size_t s = 0; s < strip.places.size(); ++s) {
    const auto* column = columnOf(life, strip.places[s]);
    p.setPen(secondPen(strip.look == StripLook::Bars ? theme_.ink : colourOf(strip, s)));
    if (column) drawCurve(p, life, *column, where, range, look);
  }
}

QPen StripPainter::secondPen(const QColor& ofFirst) const {
  constexpr float kStrength = 0.65f;
  QColor lighter = ofFirst;
  lighter.setAlphaF(kStrength);
  QPen pen(lighter, 1.1);
  pen.setDashPattern({4, 3});
  pen.setCapStyle(Qt::FlatCap);
  return pen;
}

void StripPainter::drawCurve(QPainter& p, const Life& life, const std::vector<double>& values, const QRectF& where,
                             const Range& range, StripLook look) const {
  const SignalTable& table = life.table;
  const std::vector<double>&time = table.columns()[0], &episode = table.columns()[1];
  const auto [from, to] = rowsOf(life);
  const auto yOf = [&](double v) {
    return where.bottom() - (v - range.low) / (range.high - range.low) * where.height();
  };
  QPolygonF piece;
  const auto flush = [&] {
    if (look == StripLook::Filled && piece.size() > 1) {
      QPolygonF area = piece;
      area << QPointF(piece.back().x(), yOf(0)) << QPointF(piece.front().x(), yOf(0));
      const QPen pen = p.pen();
      p.setPen(Qt::NoPen);
      p.setBrush(theme_.fill);
      p.drawPolygon(area);
      p.setBrush(Qt::NoBrush);
      p.setPen(pen);
    }
    if (piece.size() > 1) p.drawPolyline(piece);
    piece.clear();
  };
  // More than two rows a pixel: of those, the least and the largest.
  const bool dense = static_cast<double>(to - from) > 2.5 * plot_.width();
  double pixel = -1, least = 0, most = 0;
  if (dense) {  // smooth lines would cost the learner speed, and look no better
    QPen thin = p.pen();
    thin.setWidthF(1);
    thin.setCosmetic(true);
    p.setPen(thin);
  }
  p.setRenderHint(QPainter::Antialiasing, !dense);
  for (std::size_t row = from; row < to; ++row) {
    if (row > from && (episode[row] != episode[row - 1] || comesAfterAGap(table, row))) flush(), pixel = -1;
    if (std::isnan(values[row])) {
      flush();
      continue;
    }
    const double x = xOf(time[row] + life.later), y = yOf(values[row]);
    if (dense) {
      if (std::floor(x) != pixel) {
        pixel = std::floor(x), least = most = y;
        piece << QPointF(x, y);
      } else if (y < least || y > most) {
        least = std::min(least, y), most = std::max(most, y);
        piece << QPointF(x, y);
      }
      continue;
    }
    if (look == StripLook::Steps && !piece.isEmpty()) piece << QPointF(x, piece.back().y());
    piece << QPointF(x, y);
  }
  flush();
  p.setRenderHint(QPainter::Antialiasing);
}

void StripPainter::drawBars(QPainter& p, const StripSignals& strip, const QRectF& where, const Range& range) const {
  const SignalTable& table = *picture_.table;
  const std::vector<double>& time = table.columns()[0];
  const auto [from, to] = rowsOf(first());
  if (to <= from + 1) return;
  const auto yOf = [&](double v) {
    return where.bottom() - (v - range.low) / (range.high - range.low) * where.height();
  };
  const double wide = plot_.width() * static_cast<double>(1) / std::max(1.0, static_cast<double>(to - from));
  const double bar = std::clamp(0.7 * wide, 1.0, 8.0);
  p.setRenderHint(QPainter::Antialiasing, false);
  for (std::size_t row = from; row < to; ++row) {
    double above = 0.0, below = 0.0;
    for (std::size_t s = 0; s < strip.places.size(); ++s) {
      const double value = table.columns()[strip.places[s]][row];
      if (std::isnan(value) || value == 0.0) continue;
      double& begin = value > 0 ? above : below;
      const QColor colour = strip.look == StripLook::Stacked ? colourOf(strip, s)
                            : value > 0                      ? theme_.accent
                                                             : theme_.fall;
      const double a = yOf(begin), b = yOf(begin + value);
      p.fillRect(QRectF(xOf(time[row]) - bar / 2, std::min(a, b), bar, std::abs(b - a)), colour);
      if (strip.look == StripLook::Stacked) begin += value;
    }
  }
  p.setRenderHint(QPainter::Antialiasing, true);
}

/// The second's bars are thin, below those of the first.
void StripPainter::drawOnOff(QPainter& p, const Life& life, const StripSignals& strip, const QRectF& where) const {
  const std::vector<double>& time = life.table.columns()[0];
  const auto [from, to] = rowsOf(life);
  const bool both = second().has_value();
  const double top = life.first ? 2 : kRowHeight - 4, height = life.first ? kRowHeight - (both ? 7 : 4) : 2.5;
  for (std::size_t s = 0; s < strip.places.size(); ++s) {
    const auto* column = columnOf(life, strip.places[s]);
    if (!column) continue;
    const std::vector<double>& values = *column;
    const double y = where.top() + kRowHeight * static_cast<double>(s) + top;
    const QColor colour =
        footOf(picture_.table->signals()[strip.places[s]]) == Foot::Right ? theme_.disabled : theme_.ink;
    for (std::size_t row = from; row < to;) {
      if (values[row] != 1.0) {
        ++row;
        continue;
      }
      std::size_t end = row;
      while (end < to && values[end] == 1.0 && (end == row || !comesAfterAGap(life.table, end))) ++end;
      const double left = xOf(time[row] + life.later), right = xOf(time[end - 1] + life.later + life.table.stepTime());
      const QRectF bar(left, y, std::max(1.5, right - left), height);
      p.setPen(Qt::NoPen);
      p.setBrush(life.first ? colour : secondPen(colour).color());
      p.drawRoundedRect(bar, life.first ? 2 : 0, life.first ? 2 : 0);
      row = end;
    }
  }
  p.setBrush(Qt::NoBrush);
}

}  // namespace surefoot
