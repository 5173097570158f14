// SPDX-License-Identifier: GPL-3.0-or-later
// What a random life of a robot looks like: a trace of it, its falls, and what they say.
#pragma once

#include "core/environment_inspection.h"
#include "ui/style/painted.h"

namespace surefoot {

class RandomLife final : public Painted<> {
  Q_OBJECT

 public:
  explicit RandomLife(QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled({864, 224}); }
  QSize minimumSizeHint() const override { return scaled({400, 140}); }

  void setInspection(const EnvironmentInspection* inspection);

 Q_SIGNALS:
  /// The fall of this number was pointed at.
  void fallAsked(int fall);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  static constexpr int kShown = 1000;  ///< steps
  QRectF plot() const { return {60, 16, width() - 60.0 - 230, height() - 16.0 - 44}; }
  double xAt(double step) const { return plot().left() + plot().width() * step / kShown; }
  void drawTrace(QPainter& painter) const;
  void drawFacts(QPainter& painter) const;

  const EnvironmentInspection* inspection_ = nullptr;
};

}  // namespace surefoot
