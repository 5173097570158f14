// SPDX-License-Identifier: GPL-3.0-or-later
// The line at the foot: simulated time, steps, speed, rule of thumb, seed; at the right the state of learning.
#pragma once

#include <QStringList>
#include <QWidget>

#include "ui/style/painted.h"

namespace surefoot {

class RunningLife;

class StatusLine final : public Painted<> {
  Q_OBJECT

 public:
  explicit StatusLine(RunningLife& life, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent*) override;

 public:
  /// Shows these instead of the life's state, until follow().
  void say(const QString& left, const QString& right);
  void follow();
  /// Its texts, from left to right.
  QStringList texts() const { return segments_ + QStringList{state_}; }

 private:
  bool following_ = true;
  void refresh();
  QStringList segments();
  QString state() const;

  RunningLife& life_;
  QStringList segments_;
  int cautious_ = -1;  // the segment that warns
  QString state_;
};

}  // namespace surefoot
