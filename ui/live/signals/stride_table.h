// SPDX-License-Identifier: GPL-3.0-or-later
// The strides of a walker, a row each, with their mean and spread, and those of the second Q-function. A click marks a
// stride in the signals.
#pragma once

#include <QTableWidget>

#include "ui/live/signals/signals_shown.h"
#include "ui/style/scale.h"
#include "ui/support/exporting.h"

namespace surefoot {

class StrideTable final : public QTableWidget, public CsvSource {
  Q_OBJECT

 public:
  explicit StrideTable(SignalsShown& shown, QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled({860, 190}); }
  /// Every stride, a row each.
  std::string asCsv() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void refresh();
  std::optional<MarkedStride> strideIn(int row) const;
  void putStride(int row, const QString& name, const Stride& stride);
  void putMean(int row, const QString& name, const std::vector<Stride>& strides);

  SignalsShown& shown_;
  bool filling_ = false;
};

}  // namespace surefoot
