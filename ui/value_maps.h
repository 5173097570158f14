// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of value maps: the best action's Q large; visits and eligibility small, or, under Sarsa_2Q, its two parts.
// Axes: the first two state variables; the others follow the live state.
#pragma once

#include <QWidget>

#include "ui/value_map.h"

namespace surefoot {

class Session;

class ValueMaps final : public QWidget {
  Q_OBJECT

 public:
  explicit ValueMaps(Session& session, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {440, 264}; }
  QSize minimumSizeHint() const override { return {320, 180}; }
  /// "best action, α × α̇, β̇ live −1.80"
  QString note() const;

 Q_SIGNALS:
  void noteChanged(const QString& note);

 protected:
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override { recompute(); }

 private:
  /// Where the maps and their bars lie; Q, Q⁺ and Q⁻ share one bar.
  struct Geometry {
    QRectF big, bigBar, upper, upperBar, lower, lowerBar;
  };
  bool split() const;
  void computeParts(int cells, bool dark);
  void computeTraces(int cells, bool dark);
  void drawSmallMaps(QPainter& painter, const Geometry& geometry, const Theme& theme) const;
  void drawKey(QPainter& painter, const Geometry& geometry, const Theme& theme) const;
  Geometry geometry() const;
  void recompute();
  void drawAxes(QPainter& painter, const QRectF& square, const Theme& theme) const;

  Session& session_;
  ValueMap q_, upper_, lower_;
  MapScale qScale_, visitScale_, eligibilityScale_;
  MapSlice slice_;
  bool any_ = false;
};

}  // namespace surefoot
