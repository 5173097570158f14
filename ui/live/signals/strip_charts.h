// SPDX-License-Identifier: GPL-3.0-or-later
// Strip charts of the signals that were chosen, on one time axis with one cursor: that of the replay. A drag on the
// curves shows the body as it stood then; the wheel, + and − magnify the time, Home or a double click shows all of it;
// a strip is dragged by its name to another place, or onto another strip.
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <optional>

#include "ui/live/signals/strip_painter.h"
#include "ui/style/painted.h"
#include "ui/support/exporting.h"

namespace surefoot {

class SignalsShown;

class StripCharts final : public Painted<>, public CsvSource {
  Q_OBJECT

 public:
  explicit StripCharts(SignalsShown& shown, QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled({860, 560}); }
  QSize minimumSizeHint() const override;
  /// Time and the signals that are shown, a row a step; those of the second Q-function behind.
  std::string asCsv() const override;
  void fillMenu(QMenu& menu) override;
  StripPicture picture() const;
  /// There are signals to be drawn, and strips that were chosen.
  bool showsStrips() const;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// Where a dragged strip would go: between two strips, or onto one.
  struct Target {
    std::size_t strip;
    bool onto;
  };
  std::optional<Target> targetAt(double y) const;
  std::optional<std::size_t> stripAt(const QPointF& at) const;
  void drop(std::size_t strip, const Target& target);
  void say();

  SignalsShown& shown_;
  QRectF plot_;
  std::vector<QRectF> places_;
  double from_ = 0.0, to_ = 1.0;
  bool seeking_ = false;
  std::optional<std::size_t> dragged_;
  double dragY_ = 0.0;
  QElapsedTimer sinceSaid_;
};

}  // namespace surefoot
