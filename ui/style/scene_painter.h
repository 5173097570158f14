// SPDX-License-Identifier: GPL-3.0-or-later
// Paints the shapes of a Scene in a theme's colours.
#pragma once

#include <QPainter>
#include <functional>
#include <vector>

#include "core/scene.h"
#include "ui/style/theme.h"

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

  /// No text leaves this part of the widget; by default it may.
  void setBounds(const QRectF& bounds) { bounds_ = bounds; }
  /// Lines are so many times as thick as the scene says.
  void setStrokes(double factor) { strokes_ = factor; }

  void operator()(const Polyline& line) const;
  void operator()(const Polygon& polygon) const;
  void operator()(const Disc& disc) const;
  void operator()(const Arrow& arrow) const;
  void operator()(const Label& label) const;

  static QFont fontOf(const Label& label);

 private:
  QColor colour(Ink ink) const;
  QBrush brush(Fill fill) const;
  QPen outline(Ink ink, double width) const;
  QPolygonF pixels(const std::vector<Point>& points) const;
  QRectF within(QRectF text) const;
  /// Beside the words that are there already; null: there is no room for it.
  QRectF free(const QRectF& text) const;

  QPainter& p_;
  const Theme& t_;
  bool flash_;
  std::function<QPointF(Point)> toPixel_;
  double scale_, strokes_ = 1.0;
  QRectF bounds_;
  mutable std::vector<QRectF> words_;  // drawn so far
};

/// All of a scene; words that may lie over a body come last, so that no line goes through them.
void paintScene(const Scene& scene, const ScenePainter& painter);

}  // namespace surefoot
