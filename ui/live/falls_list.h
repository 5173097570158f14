// SPDX-License-Identifier: GPL-3.0-or-later
// The falls of the life, the newest first; a click on one shows its last seconds again, with the values as they were;
// then left and right go through them frame by frame.
#pragma once

#include <QTableView>

#include "ui/style/scale.h"
#include "ui/support/exporting.h"

namespace surefoot {

class FallsModel;
class Looking;
class RunningLife;

class FallsList final : public QTableView, public CsvSource {
  Q_OBJECT

 public:
  explicit FallsList(RunningLife& life, Looking& looking, QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled({440, 190}); }
  /// One row per kept fall.
  std::string asCsv() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void replay(const QModelIndex& index);
  void refresh();

  RunningLife& life_;
  Looking& looking_;
  FallsModel* model_;
};

}  // namespace surefoot
