// SPDX-License-Identifier: GPL-3.0-or-later
// The claims of the thesis that a recipe tests, and the results here.
#pragma once

#include <QTableWidget>

namespace surefoot {

class Experiment;

class ClaimsTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit ClaimsTable(Experiment& experiment, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  enum Column { Code, Says, Thesis, Ours, P, VerdictIs, Why };

  void refresh();
  void layOut();

  Experiment& experiment_;
};

}  // namespace surefoot
