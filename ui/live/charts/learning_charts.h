// SPDX-License-Identifier: GPL-3.0-or-later
// The course of the life: average reward and cumulative falls on one time axis, with earlier lives as faint curves.
#pragma once

#include <QChartView>
#include <QPointer>
#include <functional>
#include <optional>
#include <vector>

#include "core/life/fall.h"
#include "ui/live/charts/chart_span.h"
#include "ui/running/run_curves.h"
#include "ui/style/painted.h"
#include "ui/support/exporting.h"

class QLineSeries;
class QMenu;

namespace surefoot {

class History;
class Looking;
class RunningLife;
struct Theme;

/// A number that was said before it was seen: ◇ at the end of the axis, hollow while it can still be moved.
struct ChartPrediction {
  double value = 0;
  bool locked = false;
  double low = 0, high = 1;  ///< the range of the axis
  QString words;             ///< "your prediction for ε 0.25"
  std::optional<double> outcome{};
  std::optional<double> at{};  ///< the time that it is about; none: the end of the axis
};

/// One chart. Qt Charts draws the curves; grid, axes, marks and the list at the right are drawn here, because the
/// chart's own axes have a hyphen for the minus sign and do not line up from chart to chart. Wheel, a drag, + and −
/// magnify the time axis, Home or a double click shows all of it; the cursor (moved by the mouse or
/// the arrow keys) reads the nearest curve.
class LearningChart final : public Painted<QChartView>, public CsvSource {
  Q_OBJECT

 public:
  enum class Shows { AverageReward, Falls };
  LearningChart(RunningLife& life, Looking& looking, History& history, ChartSpan& span, Shows shows,
                QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled({440, shows_ == Shows::Falls ? 152 : 168}); }
  QSize minimumSizeHint() const override { return scaled({240, 100}); }
  /// The chart that may stand below this one; while it does, it shows the numbers of the time axis for both.
  void setBelow(const QWidget* below) { below_ = below; }
  /// A second learner's curve beside this one's (nullptr: none), while it lives.
  void setSecond(RunningLife* second);
  void setPrediction(std::optional<ChartPrediction> prediction);
  /// Words beside the number of a run, in place of its name; empty: the number alone.
  void setRunWords(std::function<QString(const RunCurve&)> words);
  void prepareExport(bool exporting) override;
  /// One row per point that is kept: life (0: the present one, 1: the one before it, …), policy, x, value.
  std::string asCsv() const override;
  void fillMenu(QMenu& menu) override;

  /// A run in the charts: the present life, the second learner's, or an earlier life.
  struct Run {
    const RunCurve* curve;
    enum class Kind { Live, Second, Earlier } kind;
  };
  std::vector<Run> runs() const;
  /// A line of the list at the right: a run, and its value at the end of the shown part.
  struct Item {
    Run run;
    double value;
    QString text, words{};
    bool predicted = false;  ///< the prediction, no run
  };
  std::vector<Item> items() const;
  /// The reading of the cursor: "3.25 min: 187.3, TRL, live"; empty: none.
  QString reading() const;
  /// Where marks of falls are drawn [px], and whether a click there replays one.
  struct FallMark {
    double x;
    bool answers, byHand;
  };
  std::vector<FallMark> fallMarks() const;
  const QRectF& plot() const { return plot_; }

 Q_SIGNALS:
  void predictionMoved(double value);

 protected:
  void drawBackground(QPainter* painter, const QRectF& rect) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  void refresh();
  void place();
  void chooseRanges();
  void chooseRewards();
  void roundRange(double least, double most);
  void drawPiece(std::size_t index, const std::vector<CurvePoint>& piece, const QPen& pen, bool fromZero);
  double xOf(const CurvePoint& point) const;
  double yOf(const CurvePoint& point) const;
  QPointF toPixel(double x, double y) const;
  double timeAt(double pixel) const;
  QString nameOf(const Run& run) const;
  double listWidth() const;
  bool hasTests() const;
  QString testsName() const;
  QString valueText(double value) const;
  QString timeText(double time) const;
  /// The last point up to a time; nullptr: the curve begins later.
  const CurvePoint* stateAt(const RunCurve& curve, double time) const;

  void drawAxes(QPainter& p, const Theme& t) const;
  void drawTimeAxis(QPainter& p, const Theme& t) const;
  /// A dashed vertical with its text: a change of a parameter, the end of learning.
  struct Mark {
    double x;
    QString text;
  };
  std::vector<Mark> marks() const;
  double timeOfStep(std::int64_t step) const;
  void drawMarks(QPainter& p, const Theme& t) const;
  QString textOf(const Change& change) const;
  const RunCurve* secondCurve() const;
  void drawFallMarks(QPainter& p, const Theme& t) const;
  /// One dot per greedy test; the average reward does not contain these tests.
  void drawTests(QPainter& p, const Theme& t) const;
  void drawList(QPainter& p, const Theme& t) const;
  void drawCursor(QPainter& p, const Theme& t) const;
  void drawPrediction(QPainter& p, const Theme& t) const;
  void drawOutcome(QPainter& p, const Theme& t) const;
  bool crossesCurve(const QRectF& box) const;
  double predictionX() const;
  void fitPrediction(double most);
  bool movesPrediction(const QPointF& at) const;
  void movePrediction(double pixel);

  /// The run and the point at the cursor.
  struct Read {
    Run run;
    CurvePoint point;
    std::size_t index;  // index in runs()
  };
  std::optional<Read> read() const;
  void moveCursor(int steps);
  void readNext(int step);
  void replayNear(double pixel);
  bool usesKey(int key) const;

  bool hasTimeAxis() const;

  static constexpr double kLeft = 48, kTop = 12, kTopWithTitle = 34, kBottom = 12,
                          kBottomWithAxis = 40;  // gutters [px]

  RunningLife& life_;
  Looking& looking_;
  History& history_;
  ChartSpan& span_;
  Shows shows_;
  QPointer<RunningLife> second_;
  std::optional<ChartPrediction> prediction_;
  bool predicting_ = false;  // it is being dragged
  std::function<QString(const RunCurve&)> runWords_;
  const QWidget* below_ = nullptr;
  bool exporting_ = false, ring_ = false, withAxis_ = false;
  std::vector<QLineSeries*> series_;  // one per piece, earlier lives first; unused ones are empty
  QRectF plot_;
  double yLeast_ = 0, yMost_ = 1, yStep_ = 1;
  std::optional<double> mouseY_;             // y of the cursor while the mouse moves it [px]
  std::optional<std::size_t> readRun_;       // index in runs(), if the keyboard chose a run
  std::optional<double> pressed_, dragged_;  // a part is being selected [px]
};

}  // namespace surefoot
