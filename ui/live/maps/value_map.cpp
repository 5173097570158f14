// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/maps/value_map.h"

#include <fmt/format.h>

#include <QElapsedTimer>
#include <algorithm>
#include <cmath>

#include "core/text/text.h"
#include "ui/style/colour_map.h"

namespace surefoot {

constexpr double kSeen = 0.18;  // viridis begins here on dark: its first colours could not be told from the panel

QRgb MapScale::colour(double value, bool dark) const {
  switch (kind) {
    case Kind::Diverging:
      return divergingColour(value >= 0 ? (high > 0 ? value / high : 0.0) : low < 0 ? -value / low : 0.0, dark);
    case Kind::Viridis:
      return viridisColour(dark ? kSeen + (1 - kSeen) * position(value) : position(value));
    case Kind::Steps:
      return viridisColour(0.06 + 0.88 * std::round(value) / std::max(high, 1.0));
    case Kind::Risk:
      return divergingColour(-position(value), dark);
    case Kind::Positive:
      break;
  }
  return divergingColour(value / high, dark);
}

double MapScale::position(double value) const {
  if (kind == Kind::Viridis) return value <= 1 ? 0.0 : std::log(value) / std::log(std::max(high, 1.001));
  if (kind == Kind::Steps) return (value + 0.5) / (high + 1);
  if (kind == Kind::Risk) return std::sqrt(std::clamp(value / high, 0.0, 1.0));
  const double from = kind == Kind::Positive ? 0.0 : low;
  return (value - from) / (high - from);
}

double MapScale::valueAt(double position) const {
  if (kind == Kind::Viridis) return std::pow(std::max(high, 1.001), position);
  if (kind == Kind::Steps) return std::floor(position * (high + 1));
  if (kind == Kind::Risk) return high * position * position;
  const double from = kind == Kind::Positive ? 0.0 : low;
  return from + position * (high - from);
}

namespace {

const StateVariable& variableOf(const Task& task, int axis) {
  return task.state[static_cast<std::size_t>(axis)];
}

/// How many values of a variable of whole numbers a map shows.
int valuesOf(const StateVariable& v) {
  return std::max(1, static_cast<int>(std::lround(v.viewHigh - v.viewLow)));
}

/// Cells along a variable: one per value, if it has few values.
int cellsOf(const StateVariable& v, int most, int coarseness) {
  if (v.whole && valuesOf(v) <= most) return valuesOf(v);
  return std::max(1, most / coarseness);
}

}  // namespace

QRectF ValueMap::area(const Task& task, const MapSlice& slice, const QRectF& square) {
  const StateVariable &x = variableOf(task, slice.xAxis), &y = variableOf(task, slice.yAxis);
  if (slice.strip()) {
    const double cell = x.whole ? square.width() / valuesOf(x) : 0.0;
    return {square.topLeft(), QSizeF(square.width(), std::clamp(cell, square.height() / 8, square.height() / 3))};
  }
  if (!x.whole || !y.whole) return square;
  const double cell = std::min(square.width() / valuesOf(x), square.height() / valuesOf(y));
  return {square.topLeft(), QSizeF(std::floor(cell * valuesOf(x)), std::floor(cell * valuesOf(y)))};
}

double ValueMap::xAt(const Task& task, double column) const {
  const StateVariable& x = variableOf(task, slice_.xAxis);
  return x.viewLow + (column + 0.5) / columns_ * (x.viewHigh - x.viewLow);
}

double ValueMap::yAt(const Task& task, double row) const {
  const StateVariable& y = variableOf(task, slice_.yAxis);
  return y.viewHigh - (row + 0.5) / rows_ * (y.viewHigh - y.viewLow);
}

void ValueMap::evaluate(const Task& task, const MapSlice& slice, int cells, const Quantity& quantity) {
  constexpr int kCoarsest = 8;
  slice_ = slice;
  const StateVariable &x = variableOf(task, slice.xAxis), &y = variableOf(task, slice.yAxis);
  whole_ = x.whole && y.whole && valuesOf(x) <= cells && valuesOf(y) <= cells;
  for (;; coarseness_ *= 2) {
    columns_ = cellsOf(x, cells, coarseness_);
    rows_ = slice.strip() ? 1 : cellsOf(y, cells, coarseness_);
    if (evaluateAll(task, quantity) || coarseness_ >= kCoarsest) return;
  }
}

bool ValueMap::evaluateAll(const Task& task, const Quantity& quantity) {
  constexpr qint64 kMost = 30, kLittle = 4;  // [ms]
  QElapsedTimer clock;
  clock.start();
  values_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  std::vector<double> state = slice_.at;
  const auto ix = static_cast<std::size_t>(slice_.xAxis), iy = static_cast<std::size_t>(slice_.yAxis);
  for (int row = 0; row < rows_; ++row) {
    state[iy] = yAt(task, row);
    for (int column = 0; column < columns_; ++column) {
      state[ix] = xAt(task, column);
      values_[static_cast<std::size_t>(row * columns_ + column)] = quantity(state);
    }
    if (row < rows_ - 1 && clock.elapsed() > kMost) {
      std::fill(values_.begin() + (row + 1) * columns_, values_.end(), std::numeric_limits<double>::quiet_NaN());
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

bool ValueMap::anyNeverVisited() const {
  return std::any_of(values_.begin(), values_.end(), [](double v) { return std::isnan(v); });
}

void ValueMap::colour(const MapScale& scale, bool dark) {
  if (image_.size() != QSize(columns_, rows_)) image_ = QImage(columns_, rows_, QImage::Format_ARGB32);
  for (int row = 0; row < rows_; ++row) {
    auto* line = reinterpret_cast<QRgb*>(image_.scanLine(row));
    for (int column = 0; column < columns_; ++column) {
      const double value = at(column, row);
      line[column] = std::isnan(value) ? qRgba(0, 0, 0, 0) : (scale.colour(value, dark) | 0xFF000000U);
    }
  }
}

QPointF ValueMap::toPixel(const Task& task, std::span<const double> state, const QRectF& square) const {
  const auto ix = static_cast<std::size_t>(slice_.xAxis), iy = static_cast<std::size_t>(slice_.yAxis);
  const StateVariable &x = task.state[ix], &y = task.state[iy];
  return {square.left() + (state[ix] - x.viewLow) / (x.viewHigh - x.viewLow) * square.width(),
          slice_.strip() ? square.center().y()
                         : square.bottom() - (state[iy] - y.viewLow) / (y.viewHigh - y.viewLow) * square.height()};
}

std::optional<std::vector<double>> ValueMap::stateAt(const Task& task, QPointF where, const QRectF& square) const {
  if (columns_ == 0 || !square.contains(where) || slice_.at.size() != task.state.size()) return std::nullopt;
  std::vector<double> state = slice_.at;
  const double column = std::floor((where.x() - square.left()) / square.width() * columns_);
  const double row = std::floor((where.y() - square.top()) / square.height() * rows_);
  if (!slice_.strip()) state[static_cast<std::size_t>(slice_.yAxis)] = yAt(task, std::clamp(row, 0.0, rows_ - 1.0));
  state[static_cast<std::size_t>(slice_.xAxis)] = xAt(task, std::clamp(column, 0.0, columns_ - 1.0));
  return state;
}

std::string ValueMap::asCsv(const Task& task, const std::string& quantity) const {
  const bool strip = slice_.strip();
  std::string csv = variableOf(task, slice_.xAxis).key + ",";
  if (!strip) csv += variableOf(task, slice_.yAxis).key + ",";
  csv += csvCell(quantity) + "\n";
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const double value = at(column, row);
      csv += fmt::format("{:.9g},", xAt(task, column));
      if (!strip) csv += fmt::format("{:.9g},", yAt(task, row));
      csv += (std::isnan(value) ? "" : fmt::format("{:.9g}", value)) + "\n";
    }
  return csv;
}

}  // namespace surefoot
