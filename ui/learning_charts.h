// SPDX-License-Identifier: GPL-3.0-or-later
// The course of the life: average reward and cumulative falls on one time axis, with earlier lives as faint curves.
#pragma once

#include <QChartView>
#include <QPointer>
#include <vector>

#include "ui/exporting.h"

class QLineSeries;

namespace surefoot {

class Session;
struct Theme;
struct RunCurve;
struct CurvePoint;
struct Change;

/// The next of 1, 2, 5 × a power of ten that is not below the value.
double niceAbove(double value);

/// One chart. Qt Charts draws the curves; grid, axes, marks and the list at the right are drawn here, because the
/// chart's own axes have a hyphen for the minus sign and do not line up from chart to chart.
class LearningChart final : public QChartView, public CsvSource {
  Q_OBJECT

 public:
  enum class Shows { AverageReward, Falls };
  LearningChart(Session& session, Shows shows, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {440, shows_ == Shows::Falls ? 152 : 168}; }
  QSize minimumSizeHint() const override { return {240, 110}; }
  /// The chart that stands below this one and bears the numbers of the time axis for both, while it is shown.
  void setBelow(const QWidget* below) { below_ = below; }
  /// A second learner's curve beside this one's (nullptr: none), while it lives.
  void setSecond(Session* second);
  /// All of the life, or only as far as it learned.
  void setLearningOnly(bool on);
  void prepareExport(bool exporting) override;
  /// A row a point: life (0 the one that runs, 1 the one before …), policy, x, value.
  std::string asCsv() const override;

 protected:
  void drawBackground(QPainter* painter, const QRectF& rect) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  void refresh();
  void place();
  void chooseRanges();
  void drawPiece(std::size_t index, const std::vector<CurvePoint>& piece, const QPen& pen);
  double xOf(const CurvePoint& point) const;  // [min], or episodes where the task has no clock
  double yOf(const CurvePoint& point) const;
  QPointF toPixel(double x, double y) const;
  void drawAxes(QPainter& p, const Theme& t) const;
  /// A dashed vertical with its text: a change of a parameter, the end of learning.
  struct Mark {
    double x;
    QString text;
  };
  std::vector<Mark> marks() const;
  void drawMarks(QPainter& p, const Theme& t) const;
  QString textOf(const Change& change) const;
  const RunCurve* secondCurve() const;
  void drawFallMarks(QPainter& p, const Theme& t) const;
  /// A dot a greedy test, which the average does not hold.
  void drawTests(QPainter& p, const Theme& t) const;
  void drawList(QPainter& p, const Theme& t) const;

  bool hasTimeAxis() const { return exporting_ || !below_ || !below_->isVisible(); }

  static constexpr double kLeft = 48, kRight = 98, kTop = 12, kTopWithTitle = 34, kBottom = 12,
                          kBottomWithAxis = 40;  // gutters [px]

  Session& session_;
  Shows shows_;
  QPointer<Session> second_;
  const QWidget* below_ = nullptr;
  bool learningOnly_ = false, exporting_ = false;
  std::vector<QLineSeries*> series_;  // one a piece, earlier lives first; those not needed are empty
  QRectF plot_;
  double xMost_ = 1, yLeast_ = 0, yMost_ = 1;
};

}  // namespace surefoot
