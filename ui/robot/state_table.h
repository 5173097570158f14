// SPDX-License-Identifier: GPL-3.0-or-later
// The state variables of a robot with what a random life made of them, its actions and its endings. What is proposed
// writes itself into the text.
#pragma once

#include "core/environment_inspection.h"
#include "ui/style/painted.h"

namespace surefoot {

class StateTable final : public Painted<> {
  Q_OBJECT

 public:
  explicit StateTable(QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {scaled(236), sizeHint().height()}; }

  void setInspection(const EnvironmentInspection* inspection);

 Q_SIGNALS:
  void lineAsked(int line);
  void rangeProposed(const SeenState& state);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  int rowAt(double y) const;
  /// Whether a click there writes the range that is proposed.
  bool isProposal(const SeenState& state, double x) const;
  double top(int row) const { return 32.0 + 28.0 * row; }
  /// The widths of tiles and the units go first where there is little room.
  bool hasTiles() const { return width() >= 380; }
  double histogramAt() const { return width() - 12 - (hasTiles() ? 142 : 68); }
  void drawRow(QPainter& painter, const SeenState& state, double y, bool chosen) const;
  void drawHistogram(QPainter& painter, const SeenState& state, const QRectF& where) const;
  void drawEndings(QPainter& painter, double y) const;
  void choose(int row);

  const EnvironmentInspection* inspection_ = nullptr;
  int chosen_ = -1;
};

}  // namespace surefoot
