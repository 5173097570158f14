// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/value_map.h"

#include <fmt/format.h>

#include <QElapsedTimer>
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
    case Kind::Steps:
      return viridisColour(0.06 + 0.88 * std::round(value) / std::max(high, 1.0));
    case Kind::Positive:
      break;
  }
  return divergingColour(value / high, dark);
}

double MapScale::position(double value) const {
  if (kind == Kind::Viridis) return value <= 1 ? 0.0 : std::log(value) / std::log(std::max(high, 1.001));
  if (kind == Kind::Steps) return (value + 0.5) / (high + 1);
  const double from = kind == Kind::Positive ? 0.0 : low;
  return (value - from) / (high - from);
}

double MapScale::valueAt(double position) const {
  if (kind == Kind::Viridis) return std::pow(std::max(high, 1.001), position);
  if (kind == Kind::Steps) return std::floor(position * (high + 1));
  const double from = kind == Kind::Positive ? 0.0 : low;
  return from + position * (high - from);
}

void ValueMap::evaluate(const Task& task, const MapSlice& slice, int cells, const Quantity& quantity) {
  constexpr int kCoarsest = 8;
  slice_ = slice;
  for (;; coarseness_ *= 2) {
    cells_ = std::max(1, cells / coarseness_);
    if (evaluateAll(task, quantity) || coarseness_ >= kCoarsest) return;
  }
}

bool ValueMap::evaluateAll(const Task& task, const Quantity& quantity) {
  constexpr qint64 kMost = 30, kLittle = 4;  // [ms]
  const MapSlice& slice = slice_;
  const int cells = cells_;
  QElapsedTimer clock;
  clock.start();
  values_.resize(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
  std::vector<double> state = slice.at;
  const auto ix = static_cast<std::size_t>(slice.xAxis), iy = static_cast<std::size_t>(slice.yAxis);
  const StateVariable &x = task.state[ix], &y = task.state[iy];
  for (int row = 0; row < cells; ++row) {
    state[iy] = y.viewHigh - (row + 0.5) / cells * (y.viewHigh - y.viewLow);
    for (int column = 0; column < cells; ++column) {
      state[ix] = x.viewLow + (column + 0.5) / cells * (x.viewHigh - x.viewLow);
      values_[static_cast<std::size_t>(row * cells + column)] = quantity(state);
    }
    if (row < cells - 1 && clock.elapsed() > kMost) {
      std::fill(values_.begin() + (row + 1) * cells, values_.end(), std::numeric_limits<double>::quiet_NaN());
      return false;
    }
  }
  if (coarseness_ > 1 && clock.elapsed() < kLittle) coarseness_ /= 2;  // from the next time on
  return true;
}

std::optional<std::pair<double, double>> ValueMap::range() const {
  std::optional<std::pair<double, double>> range;
  for (const double v : values_) {
    if (std::isnan(v)) continue;
    range = range ? std::pair{std::min(range->first, v), std::max(range->second, v)} : std::pair{v, v};
  }
  return range;
}

void ValueMap::colour(const MapScale& scale, bool dark) {
  if (image_.width() != cells_) image_ = QImage(cells_, cells_, QImage::Format_ARGB32);
  for (int row = 0; row < cells_; ++row) {
    auto* line = reinterpret_cast<QRgb*>(image_.scanLine(row));
    for (int column = 0; column < cells_; ++column) {
      const double value = at(column, row);
      line[column] = std::isnan(value) ? qRgba(0, 0, 0, 0) : (scale.colour(value, dark) | 0xFF000000U);
    }
  }
}

QPointF ValueMap::toPixel(const Task& task, std::span<const double> state, const QRectF& square) const {
  const auto ix = static_cast<std::size_t>(slice_.xAxis), iy = static_cast<std::size_t>(slice_.yAxis);
  const StateVariable &x = task.state[ix], &y = task.state[iy];
  return {square.left() + (state[ix] - x.viewLow) / (x.viewHigh - x.viewLow) * square.width(),
          square.bottom() - (state[iy] - y.viewLow) / (y.viewHigh - y.viewLow) * square.height()};
}

std::optional<std::vector<double>> ValueMap::stateAt(const Task& task, QPointF where, const QRectF& square) const {
  if (cells_ == 0 || !square.contains(where)) return std::nullopt;
  std::vector<double> state = slice_.at;
  const auto ix = static_cast<std::size_t>(slice_.xAxis), iy = static_cast<std::size_t>(slice_.yAxis);
  if (state.size() != task.state.size()) return std::nullopt;
  const StateVariable &x = task.state[ix], &y = task.state[iy];
  const double column = std::floor((where.x() - square.left()) / square.width() * cells_);
  const double row = std::floor((where.y() - square.top()) / square.height() * cells_);
  state[ix] = x.viewLow + (std::clamp(column, 0.0, cells_ - 1.0) + 0.5) / cells_ * (x.viewHigh - x.viewLow);
  state[iy] = y.viewHigh - (std::clamp(row, 0.0, cells_ - 1.0) + 0.5) / cells_ * (y.viewHigh - y.viewLow);
  return state;
}

std::string ValueMap::asCsv(const Task& task, const std::string& quantity) const {
  const StateVariable &x = task.state[static_cast<std::size_t>(slice_.xAxis)],
                      &y = task.state[static_cast<std::size_t>(slice_.yAxis)];
  std::string csv = fmt::format("{},{},{}\n", x.key, y.key, csvCell(quantity));
  for (int row = 0; row < cells_; ++row)
    for (int column = 0; column < cells_; ++column) {
      const double value = at(column, row);
      csv += fmt::format("{:.9g},{:.9g},{}\n", x.viewLow + (column + 0.5) / cells_ * (x.viewHigh - x.viewLow),
                         y.viewHigh - (row + 0.5) / cells_ * (y.viewHigh - y.viewLow),
                         std::isnan(value) ? "" : fmt::format("{:.9g}", value));
    }
  return csv;
}

// Marching squares between the centres of cells; a cell never visited counts as below.
void ValueMap::drawContour(QPainter& p, const QRectF& square, double level) const {
  const double w = square.width() / cells_, h = square.height() / cells_;
  const auto value = [&](int column, int row) {
    const double v = at(column, row);
    return std::isnan(v) ? level - 1e3 : v;
  };
  const auto centre = [&](int column, int row) {
    return QPointF(square.left() + (column + 0.5) * w, square.top() + (row + 0.5) * h);
  };
  for (int row = 0; row + 1 < cells_; ++row)
    for (int column = 0; column + 1 < cells_; ++column) {
      const int columns[] = {column, column + 1, column + 1, column}, rows[] = {row, row, row + 1, row + 1};
      QPointF cuts[4];
      int count = 0;
      for (int i = 0; i < 4; ++i) {
        const int j = (i + 1) % 4;
        const double a = value(columns[i], rows[i]), b = value(columns[j], rows[j]);
        if ((a > level) == (b > level)) continue;
        const double t = (level - a) / (b - a);
        cuts[count++] = centre(columns[i], rows[i]) * (1 - t) + centre(columns[j], rows[j]) * t;
      }
      if (count >= 2) p.drawLine(cuts[0], cuts[1]);
      if (count == 4) p.drawLine(cuts[2], cuts[3]);
    }
}

namespace {

/// "150", "0.012", or a power of ten: "10⁴".
QString numberText(double value, const MapScale& scale) {
  if (scale.kind != MapScale::Kind::Viridis || value < 100) {
    const double size = std::abs(value);
    if (value == std::floor(value) || size >= 100) return toText(fixedText(value, 0));
    if (size >= 1) return toText(fixedText(value, 1));
    if (size < 0.1) return toText(fixedText(value, 3));
    const std::string text = fixedText(value, 2);
    return toText(text.ends_with('0') ? fixedText(value, 1) : text);
  }
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

void ValueMap::draw(QPainter& p, const QRectF& square, const Theme& t, const Task& task, const MapMarks& marks) const {
  p.save();
  p.setClipRect(square);
  p.setRenderHint(QPainter::Antialiasing);
  drawHatching(p, square, t);
  p.setRenderHint(QPainter::Antialiasing, false);
  if (!image_.isNull()) p.drawImage(square, image_);
  p.setRenderHint(QPainter::Antialiasing);
  p.setBrush(Qt::NoBrush);
  if (marks.contour) {
    p.setPen(QPen(t.ink, 1.5));
    drawContour(p, square, *marks.contour);
  }
  const auto cross = [&](const QPointF& at, const QPen& pen) {
    p.setPen(pen);
    p.drawLine(QPointF(at.x(), square.top()), QPointF(at.x(), square.bottom()));
    p.drawLine(QPointF(square.left(), at.y()), QPointF(square.right(), at.y()));
  };
  if (marks.live.size() == task.state.size()) {
    const QPointF at = toPixel(task, marks.live, square);
    QColor hair = t.ink;
    hair.setAlphaF(0.45f);
    if (marks.ring > 5 && marks.cursor.empty()) cross(at, QPen(hair, 1));
    p.setPen(QPen(t.panel, 4.5));
    p.drawEllipse(at, marks.ring, marks.ring);
    p.setPen(QPen(t.ink, 2));
    p.drawEllipse(at, marks.ring, marks.ring);
  }
  if (marks.cursor.size() == task.state.size()) cross(toPixel(task, marks.cursor, square), QPen(t.accent, 1));
  p.restore();
  p.setPen(QPen(t.outline, 1));
  p.setBrush(Qt::NoBrush);
  p.drawRect(square.adjusted(-0.5, -0.5, 0.5, 0.5));
}

void ValueMap::drawBar(QPainter& p, const QRectF& bar, const MapScale& scale, const Theme& t,
                       std::span<const double> numbers, std::span<const QString> names) {
  p.save();
  p.setRenderHint(QPainter::Antialiasing, false);
  const int rows = static_cast<int>(bar.height());
  for (int row = 0; row < rows; ++row) {
    const double value = scale.valueAt(1.0 - (row + 0.5) / rows);
    p.fillRect(QRectF(bar.left(), bar.top() + row, bar.width(), 1), QColor::fromRgb(scale.colour(value, t.dark)));
  }
  p.setFont(textFont(11));
  double last = -1e9;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double value = numbers[i];
    const double y = bar.bottom() - scale.position(value) * bar.height();
    if (std::abs(y - last) < 12) continue;  // no room for another number
    last = y;
    p.setPen(QPen(t.outline, 1));
    p.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 3, y));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(bar.right() + 6, y - 8, 40, 16), Qt::AlignLeft,
               i < names.size() ? names[i] : numberText(value, scale));
  }
  p.restore();
}

}  // namespace surefoot
