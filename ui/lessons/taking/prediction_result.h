// SPDX-License-Identifier: GPL-3.0-or-later
// "You said 40, it came to 71 falls": what the step before predicted, and what came out.
#pragma once

#include <QWidget>

class QHBoxLayout;

namespace surefoot {

class LessonDriver;

class PredictionResult final : public QWidget {
  Q_OBJECT

 public:
  /// The step before the one in hand predicted, and its run is over.
  static bool there(const LessonDriver& driver);
  PredictionResult(const LessonDriver& driver, QWidget* parent);

 private:
  void addNumber(QHBoxLayout& row, double value, bool falls);
};

}  // namespace surefoot
