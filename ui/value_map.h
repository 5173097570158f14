// SPDX-License-Identifier: GPL-3.0-or-later
// One heat map of a quantity over two state variables, in whole cells, with its colour bar.
#pragma once

#include <QImage>
#include <QRectF>
#include <functional>
#include <span>

#include "core/environment.h"
#include "ui/theme.h"

class QPainter;

namespace surefoot {

/// How numbers become colours, and which numbers stand at the bar.
struct MapScale {
  enum class Kind { Diverging, Viridis, Positive };
  Kind kind = Kind::Diverging;
  double low = -100, high = 200;  ///< Diverging: each side on its own. Viridis: logarithmic, from 1
  QRgb colour(double value, bool dark) const;
  /// 0 … 1 along the bar.
  double position(double value) const;
  double valueAt(double position) const;
};

/// Which slice of the state space: two axes, the other variables fixed.
struct MapSlice {
  int xAxis = 0, yAxis = 1;
  std::vector<double> at;  ///< a whole state; its entries of the two axes do not matter
};

class ValueMap {
 public:
  /// NaN: never visited, hatched.
  using Quantity = std::function<double(std::span<const double> state)>;

  /// Evaluates the quantity at the centre of each of cells × cells.
  void compute(const Task& task, const MapSlice& slice, int cells, const MapScale& scale, const Quantity& quantity,
               bool dark);

  /// Draws the map into a square; hatching, frame, and the ring of the live state.
  void draw(QPainter& painter, const QRectF& square, const Theme& theme, const Task& task, std::span<const double> live,
            double ringRadius) const;
  /// What stands for "never visited".
  static void drawHatching(QPainter& painter, const QRectF& where, const Theme& theme);
  /// Draws a bar with numbers at its right.
  static void drawBar(QPainter& painter, const QRectF& bar, const MapScale& scale, const Theme& theme,
                      std::span<const double> numbers);

 private:
  QImage image_;
  MapSlice slice_;
};

}  // namespace surefoot
