// SPDX-License-Identifier: GPL-3.0-or-later
// The robot as its text describes it: the drawing with names and the limits of its joints as handles that write into
// the text, or a trial that moves.
#pragma once

#include <optional>

#include "core/environment_inspection.h"
#include "ui/style/painted.h"

namespace surefoot {

class RobotPicture final : public Painted<> {
  Q_OBJECT

 public:
  explicit RobotPicture(QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled({439, 448}); }
  QSize minimumSizeHint() const override { return scaled({220, 160}); }

  void setInspection(const EnvironmentInspection* inspection);
  /// A scene that moves, in place of the drawing; nothing: the drawing.
  void setMoving(std::optional<Scene> scene);
  /// The caret's line of the text: the part that stands there is lit.
  void setLine(int line);

 Q_SIGNALS:
  void lineAsked(int line);
  /// A handle was moved to this angle [rad].
  void limitMoved(const AngleHandle& handle, double angle);
  /// A key that a trial may want.
  void keyPressed(int key);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent*) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  const Scene& scene() const { return moving_ ? *moving_ : inspection_->drawing; }
  void measure();
  QPointF toPixel(Point at) const;
  QPointF placeOf(const AngleHandle& handle) const;
  std::optional<std::size_t> handleAt(QPointF at) const;
  const NamedPart* partAt(QPointF at) const;
  void drawFloor(QPainter& painter) const;
  void drawNames(QPainter& painter) const;
  void drawHandles(QPainter& painter) const;
  void moveHandle(double by);
  double angleOf(const AngleHandle& handle, QPointF at) const;

  const EnvironmentInspection* inspection_ = nullptr;
  std::optional<Scene> moving_;
  double scale_ = 1.0, floor_ = 0.0;
  int line_ = 0;
  bool inside_ = false;
  std::optional<std::size_t> chosen_, held_;  // handles
  const NamedPart* pointed_ = nullptr;
};

}  // namespace surefoot
