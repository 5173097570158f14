// SPDX-License-Identifier: GPL-3.0-or-later
// A slider in ink: a 3 px track and a 12 px knob; a ring in the accent colour while it has the focus.
#pragma once

#include <QSlider>

#include "ui/style/painted.h"

namespace surefoot {

class Slider final : public Painted<QSlider> {
  Q_OBJECT

 public:
  static constexpr int kSteps = 1000;  ///< value() runs from 0 to this

  explicit Slider(QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled({54, 24}); }
  QSize minimumSizeHint() const override { return scaled({54, 24}); }

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  double knob() const;  // its centre [px]
  void follow(const QMouseEvent& event);
};

}  // namespace surefoot
