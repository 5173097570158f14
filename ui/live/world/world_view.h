// SPDX-License-Identifier: GPL-3.0-or-later
// The animated world: draws an environment's Scene, with floor and metre scale, a camera that follows, the trail of the
// tip, and the read-outs below.
#pragma once

#include <QPointer>
#include <QWidget>
#include <deque>
#include <optional>

#include "core/environment.h"
#include "core/scene.h"
#include "ui/style/painted.h"

class QPainter;

namespace surefoot {

class Looking;
class RunningLife;
struct Theme;

class WorldView final : public Painted<> {
  Q_OBJECT

 public:
  explicit WorldView(RunningLife& life, Looking& looking, QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled({576, 400}); }
  QSize minimumSizeHint() const override { return scaled(beside_ ? QSize(216, 246) : QSize(240, 220)); }
  /// Somebody holds the body with the mouse.
  bool held() const { return hand_.has_value(); }
  void fit();  ///< the zoom that shows everything
  /// Another world that is shown beside this one, in the same size (nullptr: none). `which` is "First" or "Second",
  /// this world's name in the caption, which also shows the policy and agent.
  void setBeside(WorldView* other, const QString& which);
  double pixelsPerMetre() const;  ///< the scale of the picture
  /// Without the numbers below the picture.
  void setPlain(bool plain) { plain_ = plain; }
  /// Where the tip that one takes hold of is [px].
  QPointF tip() const { return toPixel(scene_.tip); }

 protected:
  void paintEvent(QPaintEvent*) override;
  void focusInEvent(QFocusEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void nextFrame();
  QPointF toPixel(Point p) const;
  void measure();
  double floorLevel() const;
  double strokes() const;
  double captionHeight() const;

  Point toMetres(QPointF at) const;
  bool overBody(QPointF at) const;
  void drawGhost(QPainter& painter, const Theme& theme) const;
  void drawSpring(QPainter& painter, const Theme& theme) const;
  void drawFloor(QPainter& painter, const Theme& theme) const;
  void drawTrail(QPainter& painter, const Theme& theme) const;
  void drawPicture(QPainter& painter, const Theme& theme) const;
  void drawReadOuts(QPainter& painter, const Theme& theme) const;
  void drawCaption(QPainter& painter, const Theme& theme) const;
  void drawChoice(QPainter& painter, const Theme& theme) const;

  RunningLife& life_;
  Looking& looking_;
  QPointer<WorldView> beside_;
  QString which_;
  Scene scene_;
  std::vector<ReadOut> readOuts_;
  int ownColumns_ = 1, columns_ = 1;  // columns of read-outs: with room, and in use
  double readOutsHeight_ = 0;         // [px]
  double band_ = 0;                   // height of all below the floor while the picture is not moved [px]
  double fit_ = 0;                    // [px/m]
  bool ring_ = false, plain_ = false, hasNumbers_ = true;
  double camera_ = 0;                        // x in the middle of the picture [m]
  static constexpr std::size_t kTrail = 14;  // frames
  std::deque<Point> trail_;
  double zoom_ = 1.0;
  QPointF pan_;                  // [px]
  std::optional<QPointF> hand_;  // where the body is held [px]
  std::optional<QPointF> panning_;
};

}  // namespace surefoot
