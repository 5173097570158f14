// SPDX-License-Identifier: GPL-3.0-or-later
// The table of an experiment: one row per condition, with falls, the change against the reference, its significance,
// and the statement of the thesis.
#pragma once

#include <QTableWidget>

namespace surefoot {

class Experiment;
struct Finding;

class FindingsTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit FindingsTable(Experiment& experiment, QWidget* parent = nullptr);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  enum Column {
    Name,
    Lives,
    Falls,
    PlusMinus,
    ChangeIs,
    Range,
    P,
    Holm,
    Mark,
    Time,
    Explored,
    GreedyEnd,
    Thesis,
    VerdictIs
  };

  void refresh();
  void fillRow(int row, const Finding& finding);
  void showChosen();

  Experiment& experiment_;
};

}  // namespace surefoot
