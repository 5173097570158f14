// SPDX-License-Identifier: GPL-3.0-or-later
// Paints the shapes of a Scene in a theme's colours.
#pragma once

#include <QPainter>
#include <functional>

#include "core/scene.h"
#include "ui/theme.h"

namespace surefoot {

class ScenePainter {
 public:
  /// `flash`: the body is drawn in the colour of falling. `toPixel` maps metres to the widget.
  ScenePainter(QPainter& painter, const Theme& theme, bool flash, std::function<QPointF(Point)> toPixel,
               double pixelsPerMetre)
      : p_(painter),
        t_(theme),
        flash_(flash),
        toPixel_(std::move(toPixel)),
        scale_(pixelsPerMetre) {}

  void operator()(const Polyline& line) const;
  void operator()(const Polygon& polygon) const;
  void operator()(const Disc& disc) const;
  void operator()(const Arrow& arrow) const;
  void operator()(const Label& label) const;

 private:
  QColor colour(Ink ink) const;
  QBrush brush(Fill fill) const;
  QPen outline(Ink ink, double width) const;
  QPolygonF pixels(const std::vector<Point>& points) const;

  QPainter& p_;
  const Theme& t_;
  bool flash_;
  std::function<QPointF(Point)> toPixel_;
  double scale_;
};

}  // namespace surefoot
