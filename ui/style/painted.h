// SPDX-License-Identifier: GPL-3.0-or-later
// Widgets that are drawn by hand, in pixels at text size 1 (see ui/scale.h). Inside such a class width(), height(),
// rect() and size() are in those pixels, rounded up; a ScaledPainter enlarges the drawing, mouseAt() says where the
// mouse is and place() puts a child widget.
#pragma once

#include <QMouseEvent>
#include <QPainter>
#include <QWidget>
#include <cmath>

#include "ui/style/scale.h"

namespace surefoot {

class ScaledPainter final : public QPainter {
 public:
  explicit ScaledPainter(QPaintDevice* device) : QPainter(device) { scale(textSize(), textSize()); }
};

template <class Base = QWidget>
class Painted : public Base {
 public:
  using Base::Base;
  int width() const { return designed(Base::width()); }
  int height() const { return designed(Base::height()); }
  QSize size() const { return {width(), height()}; }
  QRect rect() const { return {0, 0, width(), height()}; }
  /// For a line along the lower edge; height() may be up to a pixel too much.
  QRectF lowerEdge() const { return {0, Base::height() / textSize() - 1, double(width()), 1}; }

 protected:
  /// Where the mouse or the wheel is, in the pixels of the drawing.
  static QPointF mouseAt(const QSinglePointEvent& event) { return event.position() / textSize(); }

  /// A child widget at a place of the drawing; edges that meet in the drawing meet on the screen.
  static void place(QWidget& child, const QRect& where) {
    const QPoint from(scaled(where.x()), scaled(where.y()));
    const QPoint to(scaled(where.x() + where.width()), scaled(where.y() + where.height()));
    child.setGeometry(QRect(from, to - QPoint(1, 1)));
  }

  /// Where a child widget is, in the pixels of the drawing.
  static QRectF placeOf(const QWidget& child) {
    const QRectF r = child.geometry();
    return {r.topLeft() / textSize(), r.size() / textSize()};
  }

 private:
  static int designed(int pixels) { return static_cast<int>(std::ceil(pixels / textSize() - 1e-6)); }
};

}  // namespace surefoot
