// SPDX-License-Identifier: GPL-3.0-or-later
// What a step asks, as controls in the lesson's column: one class for each kind of question.
#pragma once

#include <QWidget>

#include "ui/lessons/taking/lesson_driver.h"

class QButtonGroup;
class QKeyEvent;
class QLabel;
class QVBoxLayout;

namespace surefoot {

class QuestionBox : public QWidget {
  Q_OBJECT

 public:
  QuestionBox(LessonDriver& driver, const QString& heading, QWidget* parent);
  /// The control where the focus goes when the step begins.
  virtual QWidget* first() = 0;
  /// The answer that is chosen now, given: what Next does.
  virtual void check() {}
  /// What stands on the button that gives the answer; empty: it has a button of its own, or needs none.
  virtual QString nextWord() const { return {}; }

 Q_SIGNALS:
  /// A number that is being said, before it is given.
  void predictionMoved(double value);
  /// A judgement is shown here.
  void told(QWidget* verdict);

 protected:
  /// A key 1, 2, 3 … chooses an option, Enter gives the answer; false: it is another key.
  bool takeKey(QKeyEvent& event, const QButtonGroup& options);
  /// The driver's judgement of the last answer.
  void tell(const LessonVerdict& verdict);
  QVBoxLayout& column() { return *column_; }
  QLabel* addQuestion(const QString& text);
  QLabel* addNote(const QString& text);

  LessonDriver& driver_;
  QVBoxLayout* column_;
  QLabel* verdict_;
};

/// nullptr: the step asks nothing.
QuestionBox* makeQuestion(LessonDriver& driver, QWidget* parent);

/// "YOUR PREDICTION": a head in small capitals.
QLabel* makeHead(const QString& text, QWidget* parent);

}  // namespace surefoot
