// SPDX-License-Identifier: GPL-3.0-or-later
// The course of the life: average reward and cumulative falls on one time axis, with earlier lives as faint curves.
#pragma once

#include <QChartView>
#include <vector>

class QLineSeries;

namespace surefoot {

class Session;
struct Theme;
struct RunCurve;
struct CurvePoint;
struct Change;

/// One chart. Qt Charts draws the curves; grid, axes, marks and the list at the right are drawn here, because the
/// chart's own axes have a hyphen for the minus sign and do not line up from chart to chart.
class LearningChart final : public QChartView {
  Q_OBJECT

 public:
  enum class Shows { AverageReward, Falls };
  LearningChart(Session& session, Shows shows, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {440, shows_ == Shows::Falls ? 152 : 168}; }
  QSize minimumSizeHint() const override { return {240, 110}; }

 protected:
  void drawBackground(QPainter* painter, const QRectF& rect) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  void place();
  void fillSeries(QLineSeries& series, const RunCurve& curve) const;
  double xOf(const CurvePoint& point) const;  // [min], or episodes where the task has no clock
  double yOf(const CurvePoint& point) const;
  QPointF toPixel(double x, double y) const;
  void drawAxes(QPainter& p, const Theme& t) const;
  void drawChanges(QPainter& p, const Theme& t) const;
  QString textOf(const Change& change) const;
  void drawVertical(QPainter& p, const Theme& t, double x, const QString& text, int line) const;
  void drawFallMarks(QPainter& p, const Theme& t) const;
  void drawList(QPainter& p, const Theme& t) const;

  Session& session_;
  Shows shows_;
  QLineSeries* live_;
  std::vector<QLineSeries*> earlier_;
  QRectF plot_;
  double xMost_ = 1, yLeast_ = 0, yMost_ = 1;
};

}  // namespace surefoot
