// SPDX-License-Identifier: GPL-3.0-or-later
// The strip above the two worlds of a comparison: how each of them learns and how it began, and the falls of both at
// equal episodes and at equal simulated time.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace surefoot {

class Combo;
class Rival;

class CompareStrip final : public QWidget {
  Q_OBJECT

 public:
  explicit CompareStrip(Rival& rival);
  /// "after 327 episodes 195 : 399 falls".
  QString falls() const;
  /// The text about the first: "● ε-greedy, Sarsa, began with an empty table".
  QString first() const;

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  void makeChoices();
  void fillAgents();
  void refresh();
  void refreshFalls();
  void chooseStart(int index);

  Rival& rival_;
  Combo *agents_, *policies_, *starts_;
  QPushButton* parameters_;
  QLabel *first_, *own_, *falls_;
};

}  // namespace surefoot
