// SPDX-License-Identifier: GPL-3.0-or-later
// A list of all signals to choose from, with a search: those that are shown stand first, in the order of their strips,
// and can be dragged to another place. "With the one above" puts two into one strip.
#pragma once

#include <QFrame>
#include <vector>

#include "ui/live/signals/strips.h"

class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace surefoot {

class SignalsShown;

class SignalChooser final : public QFrame {
  Q_OBJECT

 public:
  explicit SignalChooser(SignalsShown& shown, QWidget* parent);
  /// Fills the list and opens below a point of the screen.
  void openAt(const QPoint& below);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void fill();
  void filter();
  /// The strips as the list has them now.
  void take();
  void move(int way);
  void join();
  QListWidgetItem* add(const std::string& key, bool chosen, bool withAbove);
  void name(QListWidgetItem& item);

  SignalsShown& shown_;
  QLineEdit* search_;
  QListWidget* list_;
  bool filling_ = false;
};

}  // namespace surefoot
