// SPDX-License-Identifier: GPL-3.0-or-later
// The animated world, with a camera that follows; the mouse moves and magnifies it, and takes the body.
#pragma once

#include <QPointer>
#include <QWidget>
#include <optional>

#include "ui/live/world/world_picture.h"
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
  double pixelsPerMetre() const { return picture_.pixelsPerMetre(); }  ///< the scale of the picture
  /// Without the numbers below the picture.
  void setPlain(bool plain) { picture_.plain = plain; }
  /// Where the tip that one takes hold of is [px].
  QPointF tip() const { return picture_.toPixel(picture_.scene.tip); }

 protected:
  void paintEvent(QPaintEvent*) override;
  void focusInEvent(QFocusEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void nextFrame();
  void measure();
  double captionHeight() const;
  bool overBody(QPointF at) const;
  void drawGhost(QPainter& painter, const Theme& theme) const;
  void drawSpring(QPainter& painter, const Theme& theme) const;
  void drawCaption(QPainter& painter, const Theme& theme) const;
  void drawChoice(QPainter& painter, const Theme& theme) const;

  RunningLife& life_;
  Looking& looking_;
  QPointer<WorldView> beside_;
  QString which_;
  WorldPicture picture_;
  bool ring_ = false;
  std::optional<QPointF> hand_;  // where the body is held [px]
  std::optional<QPointF> panning_;
};

}  // namespace surefoot
