// SPDX-License-Identifier: GPL-3.0-or-later
// One heat map of a quantity over two state variables (or one: a strip), in whole cells, with its colour bar. A
// variable of whole numbers has one cell per value.
#pragma once

#include <QImage>
#include <QPolygonF>
#include <QRectF>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/environment.h"
#include "ui/style/theme.h"

class QPainter;

namespace surefoot {

/// How numbers become colours, and the numbers at the colour bar.
struct MapScale {
  enum class Kind { Diverging, Viridis, Positive, Steps, Risk };
  Kind kind = Kind::Diverging;
  double low = -100,
         high = 200;  ///< Diverging: each side on its own. Viridis: logarithmic, from 1. Steps: 0 … high. Risk: a root
  QRgb colour(double value, bool dark) const;
  /// 0 … 1 along the bar.
  double position(double value) const;
  double valueAt(double position) const;
};

/// A slice of the state space: two axes, the other variables fixed. The same axis twice: the task has only one.
struct MapSlice {
  int xAxis = 0, yAxis = 1;
  bool strip() const { return xAxis == yAxis; }
  std::vector<double> at;  ///< a whole state; its entries of the two axes do not matter
};

/// The marks that are drawn over a map.
struct MapMarks {
  std::span<const double> live;    ///< state of the world: a ring, with a crosshair if it is large
  std::span<const double> cursor;  ///< state that is looked at: a crosshair of its own
  double ring = 6;                 ///< [px]
};

class ValueMap {
 public:
  /// NaN: never visited, hatched.
  using Quantity = std::function<double(std::span<const double> state)>;

  /// Evaluates the quantity at the centres of cells × cells. Cells are fewer and larger if this would block the window
  /// (hundreds of actions, many projected variables). A variable of whole numbers has one cell per value.
  void evaluate(const Task& task, const MapSlice& slice, int cells, const Quantity& quantity);
  /// Least and greatest value; nothing if every cell was never visited.
  std::optional<std::pair<double, double>> range() const;
  bool anyNeverVisited() const;
  /// Turns values into colours.
  void colour(const MapScale& scale, bool dark);

  /// The part of a square that the map of a slice takes: cells of whole numbers are square, a strip is low.
  static QRectF area(const Task& task, const MapSlice& slice, const QRectF& square);
  /// Draws the map into its area; hatching, frame, and a line around the cells above a level.
  void draw(QPainter& painter, const QRectF& square, const Theme& theme, std::optional<double> contour = {}) const;
  /// A line around the cells of another map of the same slice that are above a level.
  void drawOutline(QPainter& painter, const QRectF& square, const Theme& theme, const ValueMap& of, double level) const;
  QPointF toPixel(const Task& task, std::span<const double> state, const QRectF& square) const;
  /// The state at the centre of the cell there; nothing outside.
  std::optional<std::vector<double>> stateAt(const Task& task, QPointF at, const QRectF& square) const;
  /// Columns "x, y, value" of all cells, named after the axes.
  std::string asCsv(const Task& task, const std::string& quantity) const;
  /// Arrows in every cell: `best`, another map of the same slice, has a bit for each direction. Right and down are
  /// positive. Nothing where cells are too small.
  void drawArrows(QPainter& painter, const QRectF& square, const Theme& theme, const ValueMap& best,
                  std::span<const QPointF> directions) const;
  bool empty() const { return values_.empty(); }
  int columns() const { return columns_; }
  int rows() const { return rows_; }

  /// The hatching for "never visited".
  static void drawHatching(QPainter& painter, const QRectF& where, const Theme& theme);
  /// Draws a bar with numbers, or with `names` at its steps, at its right.
  static void drawBar(QPainter& painter, const QRectF& bar, const MapScale& scale, const Theme& theme,
                      std::span<const double> numbers, std::span<const QString> names = {}, double room = 1e9);

  /// The live state and the cursor, drawn over everything else.
  void drawMarks(QPainter& painter, const QRectF& square, const Theme& theme, const Task& task,
                 const MapMarks& marks) const;

 private:
  /// False: it would take too long.
  bool evaluateAll(const Task& task, const Quantity& quantity);
  double at(int column, int row) const { return values_[static_cast<std::size_t>(row * columns_ + column)]; }
  double xAt(const Task& task, double column) const;
  double yAt(const Task& task, double row) const;
  void drawContour(QPainter& painter, const QRectF& square, double level) const;
  void drawBorder(QPainter& painter, const QRectF& square, double level) const;

  std::vector<double> values_;  // [row][column], the uppermost row first
  int columns_ = 0, rows_ = 0;
  bool whole_ = false;  // both axes have one cell per value
  int coarseness_ = 1;
  QImage image_;
  MapSlice slice_;
};

}  // namespace surefoot
