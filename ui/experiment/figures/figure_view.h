// SPDX-License-Identifier: GPL-3.0-or-later
// A figure of the laboratory in the window. Bars that have no room scroll. A click on a series chooses its condition,
// the mouse above it shows its numbers. With curves, the wheel and a drag magnify the time axis, and a double click
// shows all of it again. The keys for this are the arrows, + and −, Home.
#pragma once

#include <optional>

#include "ui/experiment/figures/figure_painter.h"
#include "ui/style/painted.h"
#include "ui/support/exporting.h"

class QScrollBar;

namespace surefoot {

class FigureView final : public Painted<>, public CsvSource {
  Q_OBJECT

 public:
  explicit FigureView(Figure figure, QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled(painter_.fullSize().toSize()); }
  QSize minimumSizeHint() const override { return scaled({240, 160}); }
  /// Shows another figure; if it has no series, the words instead.
  void setFigure(Figure figure, const QString& words);
  const Figure& figure() const { return painter_.figure(); }
  /// The series of this condition stands out beside the reference; empty: none.
  void setChosen(const std::string& condition);
  /// False where a panel's header shows the title already.
  void setTitleShown(bool shown);

  /// Writes NAME.png (twice the size on the screen), NAME.svg and NAME.pdf at the full size; a path without its ending.
  Status save(const std::string& path);
  std::string asCsv() const override;
  /// An exported figure has its title and its full size.
  void prepareExport(bool exporting) override;
  void fillMenu(QMenu& menu) override;

 Q_SIGNALS:
  void clicked(const QString& condition);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void layOut();
  void read(std::optional<QPointF> at);
  void moveReading(int pixels);
  void zoom(double factor, double anchor);  ///< the time at the anchor [share of the plot] stays there
  void pan(double share);
  void showAllOfIt();
  bool curves() const;
  bool usesKey(const QKeyEvent& event) const;
  QSizeF drawn() const;  ///< without the scroll bar

  FigurePainter painter_;
  QScrollBar* scroll_;
  QString words_;
  std::string chosen_;
  std::optional<QPointF> reading_, pressed_;
  QSize before_;  // the size on the screen, before an export
  bool titleShown_ = true, exporting_ = false;
};

}  // namespace surefoot
