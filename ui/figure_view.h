// SPDX-License-Identifier: GPL-3.0-or-later
// A figure of the laboratory: curves with their 95 % bands, or bars with intervals.
#pragma once

#include <QPainter>
#include <QWidget>

#include "core/laboratory/figure.h"

namespace surefoot {

struct Theme;

class FigureView final : public QWidget {
  Q_OBJECT

 public:
  static constexpr double kLeft = 64, kBottom = 48;  ///< gutters [px]
  explicit FigureView(Figure figure, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {320, 200}; }
  /// Another figure; one without series shows the words instead.
  void setFigure(Figure figure, const QString& words);
  const Figure& figure() const { return figure_; }
  /// One series stands out beside the reference, which is the first; the others are thin and without a band. Empty: all
  /// are alike.
  void setChosen(const std::string& series);
  /// A panel's header says the title already.
  void setTitleShown(bool shown) { titleShown_ = shown; }

  /// Writes NAME.png (twice the size on the screen) and NAME.pdf; a path without its ending.
  Status save(const std::string& path);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paint(QPainter& p, const Theme& t) const;
  void paintCurves(QPainter& p, const Theme& t, const QRectF& plot) const;
  void paintBars(QPainter& p, const Theme& t) const;
  void paintLegend(QPainter& p, const Theme& t, const QRectF& plot) const;
  void paintTitles(QPainter& p, const Theme& t, const QRectF& plot) const;
  void paintScene(QPainter& p, const Theme& t) const;
  void paintAxes(QPainter& p, const Theme& t, const QRectF& plot) const;
  QPen penOf(std::size_t series, const Theme& t) const;
  bool standsOut(std::size_t series) const;
  QPointF at(double x, double y, const QRectF& plot) const;
  void chooseRanges();

  double top() const { return titleShown_ ? 40 : 16; }  // [px]
  double rowHeight() const;                             // of bars [px]

  Figure figure_;
  QString words_;
  std::string chosen_;
  bool titleShown_ = true;
  double xLeast_ = 0, xMost_ = 1, yLeast_ = 0, yMost_ = 1;
};

}  // namespace surefoot
