// SPDX-License-Identifier: GPL-3.0-or-later
// How a value map and its colour bar are drawn.
#include <QPainter>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/text/text.h"
#include "ui/language/numbers.h"
#include "ui/live/maps/value_map.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

// Marching squares between the centres of cells; a cell never visited counts as below.
void ValueMap::drawContour(QPainter& p, const QRectF& square, double level) const {
  const double w = square.width() / columns_, h = square.height() / rows_;
  const auto value = [&](int column, int row) {
    const double v = at(column, row);
    return std::isnan(v) ? level - 1e3 : v;
  };
  const auto centre = [&](int column, int row) {
    return QPointF(square.left() + (column + 0.5) * w, square.top() + (row + 0.5) * h);
  };
  for (int row = 0; row + 1 < rows_; ++row)
    for (int column = 0; column + 1 < columns_; ++column) {
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

// Around whole cells that are above.
void ValueMap::drawBorder(QPainter& p, const QRectF& square, double level) const {
  const double w = square.width() / columns_, h = square.height() / rows_;
  const auto above = [&](int column, int row) { return at(column, row) > level; };  // never visited: false
  const auto corner = [&](int column, int row) { return QPointF(square.left() + column * w, square.top() + row * h); };
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      if (column + 1 < columns_ && above(column, row) != above(column + 1, row))
        p.drawLine(corner(column + 1, row), corner(column + 1, row + 1));
      if (row + 1 < rows_ && above(column, row) != above(column, row + 1))
        p.drawLine(corner(column, row + 1), corner(column + 1, row + 1));
    }
}

namespace {

/// "150", "0.012", or a power of ten: "10⁴".
QString numberText(double value, const MapScale& scale) {
  if (scale.kind != MapScale::Kind::Viridis || value < 100) {
    const double size = std::abs(value);
    if (value == std::floor(value) || size >= 100) return fixedNumber(value, 0);
    if (size >= 1) return fixedNumber(value, 1);
    if (size < 0.1) return fixedNumber(value, 3);
    const std::string text = fixedText(value, 2);
    return localNumbers(text.ends_with('0') ? fixedText(value, 1) : text);
  }
  constexpr std::array<const char*, 10> kSuperscripts = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return QStringLiteral("10") + kSuperscripts[static_cast<std::size_t>(std::lround(std::log10(value))) % 10];
}

}  // namespace

void ValueMap::drawHatching(QPainter& p, const QRectF& where, const Theme& t) {
  p.save();
  p.setClipRect(where);
  p.setRenderHint(QPainter::Antialiasing);
  QColor line = t.quiet;  // to be told from a value near 0, which has the ground's colour
  line.setAlphaF(0.6f);
  p.setPen(QPen(line, 1));
  for (double d = 0; d < where.width() + where.height(); d += 6)
    p.drawLine(QPointF(where.left() + d - where.height(), where.bottom()), QPointF(where.left() + d, where.top()));
  p.restore();
}

void ValueMap::draw(QPainter& p, const QRectF& square, const Theme& t, std::optional<double> contour) const {
  p.save();
  p.setClipRect(square);
  p.setRenderHint(QPainter::Antialiasing);
  drawHatching(p, square, t);
  p.setRenderHint(QPainter::Antialiasing, false);
  if (!image_.isNull()) p.drawImage(square, image_);
  const double cell = columns_ > 0 ? square.width() / columns_ : 0.0;
  if (whole_ && cell >= 6) {
    p.setPen(QPen(t.outline, 1));
    for (int i = 1; i < columns_; ++i)
      p.drawLine(QPointF(square.left() + i * cell, square.top()), QPointF(square.left() + i * cell, square.bottom()));
    const double row = square.height() / rows_;
    for (int i = 1; i < rows_; ++i)
      p.drawLine(QPointF(square.left(), square.top() + i * row), QPointF(square.right(), square.top() + i * row));
  }
  p.setRenderHint(QPainter::Antialiasing);
  p.setBrush(Qt::NoBrush);
  if (contour) {
    p.setPen(QPen(t.ink, 1.5));
    whole_ ? drawBorder(p, square, *contour) : drawContour(p, square, *contour);
  }
  p.restore();
  p.setPen(QPen(t.outline, 1));
  p.setBrush(Qt::NoBrush);
  p.drawRect(square.adjusted(-0.5, -0.5, 0.5, 0.5));
}

void ValueMap::drawOutline(QPainter& p, const QRectF& square, const Theme& t, const ValueMap& of, double level) const {
  if (of.empty()) return;
  p.save();
  p.setClipRect(square);
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(QPen(t.ink, 1.5));
  whole_ ? of.drawBorder(p, square, level) : of.drawContour(p, square, level);
  p.restore();
}

void ValueMap::drawMarks(QPainter& p, const QRectF& square, const Theme& t, const Task& task,
                         const MapMarks& marks) const {
  p.save();
  p.setClipRect(square);
  p.setRenderHint(QPainter::Antialiasing);
  p.setBrush(Qt::NoBrush);
  const auto cross = [&](const QPointF& at, const QPen& pen) {
    p.setPen(pen);
    p.drawLine(QPointF(at.x(), square.top()), QPointF(at.x(), square.bottom()));
    p.drawLine(QPointF(square.left(), at.y()), QPointF(square.right(), at.y()));
  };
  if (marks.live.size() == task.state.size()) {
    const QPointF at = toPixel(task, marks.live, square);
    QColor hair = t.ink;
    hair.setAlphaF(0.45f);
    if (marks.ring > 5 && marks.cursor.empty() && !whole_) cross(at, QPen(hair, 1));
    p.setPen(QPen(t.panel, 4.5));
    p.drawEllipse(at, marks.ring, marks.ring);
    p.setPen(QPen(t.ink, 2));
    p.drawEllipse(at, marks.ring, marks.ring);
  }
  if (marks.cursor.size() == task.state.size()) cross(toPixel(task, marks.cursor, square), QPen(t.accent, 1));
  p.restore();
}

void ValueMap::drawArrows(QPainter& p, const QRectF& square, const Theme& t, const ValueMap& best,
                          std::span<const QPointF> directions) const {
  if (!whole_ || best.columns_ != columns_ || best.rows_ != rows_ || image_.isNull()) return;
  const double w = square.width() / columns_, h = square.height() / rows_, reach = 0.28 * std::min(w, h);
  if (reach < 2.5) return;
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(Qt::NoPen);
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const double bits = best.at(column, row);
      if (std::isnan(bits)) continue;
      const auto actions = static_cast<std::uint32_t>(bits);
      const QPointF middle(square.left() + (column + 0.5) * w, square.top() + (row + 0.5) * h);
      const bool onDark = qGray(image_.pixel(column, row)) < 128;
      p.setBrush(onDark == t.dark ? t.ink : t.panel);
      // One points from the middle on; several that are worth the same lead away from it.
      const bool several = std::popcount(actions) > 1;
      const double size = several ? 0.6 * reach : reach;
      for (std::size_t a = 0; a < directions.size(); ++a) {
        if (!(actions >> a & 1u)) continue;
        const QPointF d = directions[a] * size, side(-d.y(), d.x());
        const QPointF c = several ? middle + directions[a] * 0.75 * reach : middle;
        p.drawPolygon(QPolygonF({c + d, c - 0.5 * d + 0.7 * side, c - 0.15 * d, c - 0.5 * d - 0.7 * side}));
      }
    }
  p.restore();
}

void ValueMap::drawBar(QPainter& p, const QRectF& bar, const MapScale& scale, const Theme& t,
                       std::span<const double> numbers, std::span<const QString> names, double room) {
  const double height = QFontMetricsF(textFont(11)).height();
  if (numbers.size() > 1 && bar.height() < 1.9 * height) return;  // with one number it could not be read
  p.save();
  p.setRenderHint(QPainter::Antialiasing, false);
  const int rows = static_cast<int>(bar.height());
  for (int row = 0; row < rows; ++row) {
    const double value = scale.valueAt(1.0 - (row + 0.5) / rows);
    p.fillRect(QRectF(bar.left(), bar.top() + row, bar.width(), 1), QColor::fromRgb(scale.colour(value, t.dark)));
  }
  p.setFont(textFont(11));
  // 0 first, where colours change their side, then the ends; between them the numbers that have room. No number leaves
  // the bar: a title stands above it.
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (order.size() > 2) std::rotate(order.begin() + 1, order.end() - 1, order.end());
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return numbers[i] == 0; });
  std::vector<double> taken;
  for (const std::size_t i : order) {
    const double value = numbers[i];
    const double y = bar.bottom() - scale.position(value) * bar.height();
    const double middle = std::clamp(y, bar.top() + height / 2, std::max(bar.top(), bar.bottom() - height / 2));
    if (std::any_of(taken.begin(), taken.end(), [&](double other) { return std::abs(other - middle) < 0.9 * height; }))
      continue;
    const QString text = i < names.size() ? names[i] : numberText(value, scale);
    if (taken.size() >= 2 && symbolWidth(p.font(), text) > room) continue;
    taken.push_back(middle);
    p.setPen(QPen(t.outline, 1));
    p.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 3, y));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(bar.right() + 6, middle - height / 2, 40, height), Qt::AlignLeft, text);
  }
  p.restore();
}

}  // namespace surefoot
