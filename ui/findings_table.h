// SPDX-License-Identifier: GPL-3.0-or-later
// The table of an experiment: a row a condition with falls, change against the reference, and its significance; below
// it the claims of the thesis, if the plan is one of its recipes.
#pragma once

#include <QTableWidget>

namespace surefoot {

class Experiment;

class FindingsTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit FindingsTable(Experiment& experiment, QWidget* parent = nullptr);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void refresh();

  Experiment& experiment_;
};

class ClaimsTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit ClaimsTable(Experiment& experiment, QWidget* parent = nullptr);

 private:
  void refresh();

  Experiment& experiment_;
};

}  // namespace surefoot
