// SPDX-License-Identifier: GPL-3.0-or-later
// How far a student has come: a dot for each step, joined by a line. Done ones are filled, the current one is ringed.
#pragma once

#include <QWidget>

#include "ui/style/painted.h"

namespace surefoot {

class StepDots final : public Painted<> {
  Q_OBJECT

 public:
  explicit StepDots(QWidget* parent = nullptr) : Painted(parent) {}
  /// `current` of `steps` (from 0); `current` == `steps`: all are done.
  void show(std::size_t current, std::size_t steps);
  QSize sizeHint() const override { return scaled({296, 16}); }
  QSize minimumSizeHint() const override { return scaled({100, 16}); }

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  std::size_t current_ = 0, steps_ = 1;
};

/// The ring of a lesson in the list: empty, partly round, or a disc with a tick; `done` from 0 to 1.
void drawProgressRing(QPainter& painter, const QPointF& centre, double done, bool onFill, const struct Theme& theme);

}  // namespace surefoot
