// SPDX-License-Identifier: GPL-3.0-or-later
// The box from which the experiment is chosen. It opens a list of plans, recipes and files, grouped, with the time that
// each takes; typed words search titles, questions and the numbers of figures ("4.6").
#pragma once

#include <QComboBox>

#include "ui/experiment/plans/plan_source.h"

class QFrame;
class QLabel;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace surefoot {

class PlanChooser final : public QComboBox {
  Q_OBJECT

 public:
  PlanChooser(const QString& name, std::vector<PlanSource> sources, QWidget* parent = nullptr);
  /// Sets the text of the box.
  void setCurrent(const QString& title);
  /// A file that was opened, or results that were left; a path that is known stands where it is, with the new title.
  void addOwn(const QString& title, const QString& path);
  void showPopup() override;
  void hidePopup() override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void planChosen(const QString& path);
  void openAsked();

 protected:
  void wheelEvent(QWheelEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void makeList();
  void fill();
  void search(const QString& words);
  void tell(QTreeWidgetItem* item);
  void take(QTreeWidgetItem* item);

  std::vector<PlanSource> sources_;
  QFrame* popup_ = nullptr;
  QLineEdit* words_ = nullptr;
  QTreeWidget* list_ = nullptr;
  QLabel* answer_ = nullptr;
};

/// "4.4–4.9", "table 4.1": the figures and tables of the thesis that a recipe shows; empty: none.
QString numbersOf(const PlanSource& source);

}  // namespace surefoot
