// SPDX-License-Identifier: GPL-3.0-or-later
// How much both robots explore: one large knob on a square-root scale, from never to every second step.
#pragma once

#include <QWidget>

#include "ui/style/painted.h"

namespace surefoot {

class ShareSlider final : public Painted<> {
  Q_OBJECT

 public:
  static constexpr double kMost = 0.5;

  explicit ShareSlider(QWidget* parent = nullptr);
  double share() const { return share_; }
  void setShare(double share);
  /// One of 24 steps along the track.
  void move(int steps);
  QSize sizeHint() const override { return scaled({660, 72}); }
  QSize minimumSizeHint() const override { return scaled({360, 72}); }

 Q_SIGNALS:
  void moved(double share);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  double xOf(double share) const;
  void follow(const QMouseEvent& event);
  double share_ = 0.1;
};

}  // namespace surefoot
