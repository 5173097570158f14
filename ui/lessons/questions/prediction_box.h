// SPDX-License-Identifier: GPL-3.0-or-later
// A number is said before it is seen: typed, dragged on the slider, or dragged on the chart; then it is locked.
#pragma once

#include "ui/lessons/questions/question_box.h"

class QDoubleSpinBox;

namespace surefoot {

class Slider;
class TextButton;

class PredictionBox final : public QuestionBox {
  Q_OBJECT

 public:
  PredictionBox(LessonDriver& driver, QWidget* parent);
  /// Dragged elsewhere.
  void setValue(double value);
  double value() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void refresh();
  QString said() const;

  QDoubleSpinBox* number_;
  Slider* slider_;
  TextButton* commit_;
  QLabel* note_;
};

}  // namespace surefoot
