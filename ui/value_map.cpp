// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/value_map.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.h"
#include "ui/colour_map.h"
#include "ui/symbol_text.h"

namespace surefoot {

QRgb MapScale::colour(double value, bool dark) const {
  switch (kind) {
    case Kind::Diverging:
      return divergingColour(value >= 0 ? value / high : -value / low, dark);
    case Kind::Viridis:
      return viridisColour(position(value));
    case Kind::Positive:
      break;
  }
  return divergingColour(value / high, dark);
}

double MapScale::position(double value) const {
  if (kind == Kind::Viridis) return value <= 1 ? 0.0 : std::log(value) / std::log(std::max(high, 1.001));
  const double from = kind == Kind::Positive ? 0.0 : low;
  return (value - from) / (high - from);
}

double MapScale::valueAt(double position) const {
  if (kind == Kind::Viridis) return std::pow(std::max(high, 1.001), position);
  const double from = kind == Kind::Positive ? 0.0 : low;
  return from + position * (high - from);
}

void ValueMap::compute(const Task& task, const MapSlice& slice, int cells, const MapScale& scale,
                       const Quantity& quantity, bool dark) {
  slice_ = slice;
  if (image_.width() != cells) image_ = QImage(cells, cells, QImage::Format_ARGB32);
  std::vector<double> state = slice.at;
  const auto ix = static_cast<std::size_t>(slice.xAxis), iy = static_cast<std::size_t>(slice.yAxis);
  const StateVariable &x = task.state[ix], &y = task.state[iy];
  for (int row = 0; row < cells; ++row) {
    state[iy] = y.viewHigh - (row + 0.5) / cells * (y.viewHigh - y.viewLow);
    auto* line = reinterpret_cast<QRgb*>(image_.scanLine(row));
    for (int column = 0; column < cells; ++column) {
      state[ix] = x.viewLow + (column + 0.5) / cells * (x.viewHigh - x.viewLow);
      const double value = quantity(state);
      line[column] = std::isnan(value) ? qRgba(0, 0, 0, 0) : (scale.colour(value, dark) | 0xFF000000U);
    }
  }
}

namespace {

/// "150", or a power of ten: "10⁴".
QString numberText(double value, const MapScale& scale) {
  if (scale.kind != MapScale::Kind::Viridis || value < 100)
    return toText(fixedText(value, value == std::floor(value) ? 0 : 1));
  constexpr std::array<const char*, 10> kSuperscripts = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return QStringLiteral("10") + kSuperscripts[static_cast<std::size_t>(std::lround(std::log10(value))) % 10];
}

}  // namespace

void ValueMap::drawHatching(QPainter& p, const QRectF& where, const Theme& t) {
  p.save();
  p.setClipRect(where);
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(QPen(t.outline, 1));
  for (double d = 0; d < where.width() + where.height(); d += 6)
    p.drawLine(QPointF(where.left() + d - where.height(), where.bottom()), QPointF(where.left() + d, where.top()));
  p.restore();
}

void ValueMap::draw(QPainter& p, const QRectF& square, const Theme& t, const Task& task, std::span<const double> live,
                    double ringRadius) const {
  p.save();
  p.setClipRect(square);
  p.setRenderHint(QPainter::Antialiasing);
  drawHatching(p, square, t);
  p.setRenderHint(QPainter::Antialiasing, false);
  if (!image_.isNull()) p.drawImage(square, image_);
  const auto ix = static_cast<std::size_t>(slice_.xAxis), iy = static_cast<std::size_t>(slice_.yAxis);
  if (live.size() > std::max(ix, iy)) {
    const StateVariable &x = task.state[ix], &y = task.state[iy];
    const QPointF at(square.left() + (live[ix] - x.viewLow) / (x.viewHigh - x.viewLow) * square.width(),
                     square.bottom() - (live[iy] - y.viewLow) / (y.viewHigh - y.viewLow) * square.height());
    p.setRenderHint(QPainter::Antialiasing);
    if (ringRadius > 5) {
      QColor hair = t.ink;
      hair.setAlphaF(0.45f);
      p.setPen(QPen(hair, 1));
      p.drawLine(QPointF(at.x(), square.top()), QPointF(at.x(), square.bottom()));
      p.drawLine(QPointF(square.left(), at.y()), QPointF(square.right(), at.y()));
    }
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(t.panel, 4.5));
    p.drawEllipse(at, ringRadius, ringRadius);
    p.setPen(QPen(t.ink, 2));
    p.drawEllipse(at, ringRadius, ringRadius);
  }
  p.restore();
  p.setPen(QPen(t.outline, 1));
  p.setBrush(Qt::NoBrush);
  p.drawRect(square.adjusted(-0.5, -0.5, 0.5, 0.5));
}

void ValueMap::drawBar(QPainter& p, const QRectF& bar, const MapScale& scale, const Theme& t,
                       std::span<const double> numbers) {
  p.save();
  p.setRenderHint(QPainter::Antialiasing, false);
  const int rows = static_cast<int>(bar.height());
  for (int row = 0; row < rows; ++row) {
    const double value = scale.valueAt(1.0 - (row + 0.5) / rows);
    p.fillRect(QRectF(bar.left(), bar.top() + row, bar.width(), 1), QColor::fromRgb(scale.colour(value, t.dark)));
  }
  p.setFont(textFont(11));
  double last = -1e9;
  for (const double value : numbers) {
    const double y = bar.bottom() - scale.position(value) * bar.height();
    if (std::abs(y - last) < 12) continue;  // no room for another number
    last = y;
    p.setPen(QPen(t.outline, 1));
    p.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 3, y));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(bar.right() + 6, y - 8, 40, 16), Qt::AlignLeft, numberText(value, scale));
  }
  p.restore();
}

}  // namespace surefoot
