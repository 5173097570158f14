// SPDX-License-Identifier: GPL-3.0-or-later
// Two signals against each other: the way through the state space, its last cycle drawn strong. Of a walker a cycle is
// a stride; where nobody walks, from one time in which the horizontal signal goes up through its mean to the next.
#pragma once

#include <QWidget>

#include "core/signals/signal_table.h"
#include "ui/style/painted.h"
#include "ui/support/exporting.h"

namespace surefoot {

class SignalsShown;

class PhasePortrait final : public Painted<>, public CsvSource {
  Q_OBJECT

 public:
  explicit PhasePortrait(SignalsShown& shown, QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled({440, 380}); }
  QSize minimumSizeHint() const override { return scaled({240, 160}); }
  /// Time and the two signals, a row a step.
  std::string asCsv() const override;
  void fillMenu(QMenu& menu) override;
  /// Menus to choose the two signals.
  void fillAxis(QMenu& menu, bool horizontal);
  QString axesText() const;

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  struct Axis {
    double low = 0.0, high = 1.0, step = 0.2;
  };
  Axis axisOf(std::size_t signal, double pixels) const;
  QPointF at(double x, double y) const;
  QPointF at(std::size_t row) const;  ///< of the first
  void drawAxes(QPainter& p) const;
  void drawWay(QPainter& p, const SignalTable& table, std::size_t from, std::size_t to) const;
  void drawArrows(QPainter& p, std::size_t from, std::size_t to) const;
  void drawLegend(QPainter& p, bool cycle) const;
  std::pair<std::size_t, std::size_t> rowsShown(const SignalTable& table) const;

  SignalsShown& shown_;
  QRectF plot_;
  Axis horizontal_, vertical_;
  std::size_t x_ = 0, y_ = 0;
};

}  // namespace surefoot
