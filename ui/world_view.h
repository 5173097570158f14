// SPDX-License-Identifier: GPL-3.0-or-later
// The animated world: draws an environment's Scene, with floor and metre scale, a camera that follows, the trail of the
// tip, and the read-outs below.
#pragma once

#include <QWidget>
#include <deque>

#include "core/scene.h"

class QPainter;

namespace surefoot {

class Session;
struct Theme;

class WorldView final : public QWidget {
  Q_OBJECT

 public:
  explicit WorldView(Session& session, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {576, 400}; }
  QSize minimumSizeHint() const override { return {320, 240}; }
  void fit();  ///< the zoom that shows everything

 protected:
  void paintEvent(QPaintEvent*) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void nextFrame();
  QPointF toPixel(Point p) const;
  double pixelsPerMetre() const;
  double floorLevel() const;
  void drawFloor(QPainter& painter, const Theme& theme) const;
  void drawTrail(QPainter& painter, const Theme& theme) const;
  void drawReadOuts(QPainter& painter, const Theme& theme) const;

  Session& session_;
  Scene scene_;
  std::deque<Point> trail_;
  double zoom_ = 1.0;
};

}  // namespace surefoot
