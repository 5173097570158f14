// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a figure of the laboratory: upright bars with intervals, curves with their 95 % bands, or a picture. Needs no
// widget, so that files can be made on any thread.
//
// The colour shows the policy, the dash of a curve the learning rule. The reference and the chosen series are thick and
// have their bands, the others are thin and light; a bar is open while lives of its condition are missing.
#pragma once

#include <QObject>
#include <QPainter>
#include <QPolygonF>

#include "core/recipes/figure.h"
#include "ui/experiment/figures/condition_name.h"

namespace surefoot {

struct Theme;

class FigurePainter {
 public:
  explicit FigurePainter(Figure figure = {});
  const Figure& figure() const { return figure_; }
  /// The series of this condition stands out beside the references; empty: none.
  void setChosen(const std::string& condition) { chosen_ = condition; }
  /// False where a panel's header shows the title already.
  void setTitleShown(bool shown) { titleShown_ = shown; }

  /// The part of the time axis of curves that is shown; none: all of it. Kept within the whole axis.
  void setTime(std::optional<std::pair<double, double>> part);
  std::pair<double, double> time() const { return {xLeast_, xMost_}; }
  bool isPart() const { return xLeast_ > xFirst_ || xMost_ < xLast_; }
  /// The time below a point of the plot.
  std::optional<double> timeAt(QPointF point, QSizeF size) const;
  /// Draws a line at this point, with the values there of the nearest curve and of the series that stand out.
  void setReading(std::optional<QPointF> point) { reading_ = point; }

  /// The range of the y axis, from its lowest to its highest tick.
  std::pair<double, double> yRange() const { return {yLeast_, yMost_}; }
  /// The smallest size in which everything can be read, also the last bar and the last name of the list [px].
  QSizeF fullSize() const;
  /// How far the bars can be scrolled to the left [px]; 0: all are visible.
  double mostScroll(QSizeF size) const;
  void paint(QPainter& p, const Theme& t, QSizeF size, double scroll = 0) const;

  /// The series at a point: a bar, a curve near it, or a name in the list.
  std::optional<std::size_t> seriesAt(QPointF point, QSizeF size, double scroll = 0) const;
  /// "TRL 50: 93.4 (84.1 … 102.7), 40 lives": the tooltip at this point.
  QString textAt(QPointF point, QSizeF size, double scroll = 0) const;

 private:
  struct BarLayout {
    QRectF plot;            ///< the part with the bars that can be seen
    double column = 0;      ///< width of one column [px]
    double gap = 0;         ///< before every group but the first
    std::vector<double> x;  ///< middles, by place, without the scroll
    int labelLines = 1;
    double whole = 0;  ///< width of all columns
  };
  BarLayout barLayout(QSizeF size) const;
  QRectF curvePlot(QSizeF size) const;
  std::vector<std::size_t> listed(QSizeF size) const;  ///< the series that have room in the list of curves, in order
  double listTop(QSizeF size) const;
  double listWidth(double most) const;
  double top() const;
  double left() const;
  double smallestColumn() const;
  double headHeight(double width) const;

  void chooseRanges();
  void leaveOutBeginning(double right, double& low, double& high) const;
  void paintGrid(QPainter& p, const Theme& t, const QRectF& plot) const;
  void paintTimeAxis(QPainter& p, const Theme& t, const QRectF& plot) const;
  void paintYTitle(QPainter& p, const Theme& t, const QRectF& plot) const;
  void paintBars(QPainter& p, const Theme& t, QSizeF size, double scroll) const;
  void paintBar(QPainter& p, const Theme& t, const QRectF& plot, double x, double column, std::size_t series) const;
  void paintMarks(QPainter& p, const Theme& t, double x, double barWidth, const QRectF& plot, std::size_t series) const;
  void paintBarLabels(QPainter& p, const Theme& t, const BarLayout& at) const;
  void paintReferences(QPainter& p, const Theme& t, const BarLayout& at) const;
  void paintBarHead(QPainter& p, const Theme& t, QSizeF size) const;
  QStringList barHead() const;
  void paintCurves(QPainter& p, const Theme& t, const QRectF& plot) const;
  void paintCurve(QPainter& p, const Theme& t, const QRectF& plot, std::size_t series) const;
  void paintPoint(QPainter& p, const Theme& t, const QRectF& plot, std::size_t series) const;
  void paintBeyond(QPainter& p, const Theme& t, const QRectF& plot, std::size_t series) const;
  void paintReading(QPainter& p, const Theme& t, QSizeF size) const;
  std::optional<std::size_t> placeAt(std::size_t series, double time) const;  ///< index of the last value by then
  void paintList(QPainter& p, const Theme& t, QSizeF size) const;
  void paintScene(QPainter& p, const Theme& t, QSizeF size) const;
  QPen penOf(std::size_t series, const Theme& t) const;
  bool standsOut(std::size_t series) const;
  bool isReference(std::size_t series) const;
  bool singlePoints() const;
  QString listName(std::size_t series) const;
  QPointF at(double x, double y, const QRectF& plot) const;
  double yOf(double value, const QRectF& plot) const { return at(0, value, plot).y(); }

  Figure figure_;
  NameGroups names_;
  std::vector<std::size_t> byEnd_;  // curves only: the series in the order of their last values, the highest first
  std::string chosen_;
  bool titleShown_ = true;
  std::optional<QPointF> reading_;
  double xFirst_ = 0, xLast_ = 1;  // all of the time axis
  double xLeast_ = 0, xMost_ = 1, yLeast_ = 0, yMost_ = 1;
};

/// "93.4 (95 %: 84.1 … 102.7)"
QString intervalText(const Interval& value);

/// Files of a figure at its full size, on any thread: PNG (twice the size on the screen), SVG or PDF by the ending.
QByteArray figureAsPicture(const Figure& figure, const std::string& chosen, const Theme& theme,
                           const std::string& ending);
/// Writes NAME.png, NAME.svg and NAME.pdf; `path` is without its ending.
Status saveFigure(const Figure& figure, const Theme& theme, const std::string& path);

}  // namespace surefoot
