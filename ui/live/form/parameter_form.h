// SPDX-License-Identifier: GPL-3.0-or-later
// The form of all parameters, made from their declarations.
#pragma once

#include <QScrollArea>
#include <QVBoxLayout>
#include <vector>

#include "core/parameters.h"
#include "ui/style/scale.h"

namespace surefoot {

class ParameterRow;
class Editing;
class History;
class RunningLife;

class ParameterForm final : public QScrollArea {
  Q_OBJECT

 public:
  explicit ParameterForm(RunningLife& life, Editing& editing, History& history, QWidget* parent = nullptr);
  /// All parameters, or only those that fit the usual window.
  void setShowAll(bool all);
  bool showsAll() const { return all_; }
  QSize sizeHint() const override { return scaled({264, 640}); }

 public Q_SLOTS:
  void resetAll();

 Q_SIGNALS:
  void refused(const QString& sentence);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Row {
    Parameter parameter;
    QVBoxLayout* place;
    ParameterRow* row = nullptr;  // made when first shown: a robot has a hundred rows that few people need
  };
  struct Section {
    QWidget* head;
    std::vector<Row> rows;
  };
  void build();
  void refresh();
  void chooseRows();
  void leaveRoomForBar();
  void make(Row& row);
  void orderTabs();
  void edit(const QString& key, double value);
  void tell(const QString& key, const Status& status);
  void askForTeacher();

  RunningLife& life_;
  Editing& editing_;
  History& history_;
  bool all_ = false;
  std::vector<Section> sections_;
};

}  // namespace surefoot
