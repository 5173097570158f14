// SPDX-License-Identifier: GPL-3.0-or-later
// The menus in the header of the value maps: quantity, axes, the other variables, the range of the colours. If there
// is no room for them, one menu "Map" holds all four.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/controls/panel.h"
#include "ui/live/maps/map_choice.h"

class QMenu;
class QToolButton;

namespace surefoot {

class MapBar final : public QWidget, public Folding {
  Q_OBJECT

 public:
  explicit MapBar(QWidget* parent = nullptr);
  /// Shows the choice for a task; `live` gives the numbers.
  void show(const MapChoice& choice, const Task& task, std::span<const double> live, bool risk);
  void fold(int room) override;

 Q_SIGNALS:
  void chosen(const MapChoice& choice);

 private:
  using Fill = void (MapBar::*)(QMenu&);
  QToolButton* addButton(const QString& name, Fill fill);
  bool matters(const QToolButton* button) const;  ///< whether the task leaves a choice there
  void fillAll(QMenu& menu);
  void setText(QToolButton* button, const QString& text);
  void choose(const MapChoice& choice);
  void fillQuantities(QMenu& menu);
  void fillAxes(QMenu& menu);
  void fillOthers(QMenu& menu);
  void fillRange(QMenu& menu);
  void addOther(QMenu& menu, std::size_t variable);

  MapChoice choice_;
  Task task_;          // a copy: the session's task is deleted with its world
  bool risk_ = false;  // it is learned
  std::vector<double> live_;
  QToolButton *quantity_, *axes_, *others_, *range_, *all_;
};

}  // namespace surefoot
