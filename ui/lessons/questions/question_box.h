// SPDX-License-Identifier: GPL-3.0-or-later
// What a step asks, as controls in the lesson's column: one class for each kind of question.
#pragma once

#include <QWidget>

#include "ui/lessons/driver/lesson_driver.h"

class QLabel;
class QPlainTextEdit;
class QVBoxLayout;

namespace surefoot {

class QuestionBox : public QWidget {
  Q_OBJECT

 public:
  QuestionBox(LessonDriver& driver, const QString& heading, QWidget* parent);
  /// The control where the focus goes when the step begins.
  QWidget* first() { return first_; }
  /// The answer that is chosen now, given: what Next does.
  virtual void check() {}
  /// What stands on the button that gives the answer; empty: it has a button of its own, or needs none.
  const QString& nextWord() const { return nextWord_; }

 Q_SIGNALS:
  /// A number that is being said, before it is given.
  void predictionMoved(double value);
  /// A judgement is shown here.
  void told(QWidget* verdict);

 protected:
  void setFirst(QWidget* first) { first_ = first; }
  void setNextWord(const QString& word) { nextWord_ = word; }
  /// The driver's judgement of the last answer.
  void tell(const LessonVerdict& verdict);
  QVBoxLayout& column() { return *column_; }
  QLabel* addQuestion(const QString& text);
  QLabel* addNote(const QString& text);
  /// A field for own words, of so many lines.
  QPlainTextEdit* addWords(int lines, const QString& name);

  LessonDriver& driver_;
  QVBoxLayout* column_;
  QLabel* verdict_;

 private:
  QLabel* addText(const QString& text, int pixels, int weight, bool quiet);
  QWidget* first_ = this;
  QString nextWord_;
};

/// nullptr: the step asks nothing.
QuestionBox* makeQuestion(LessonDriver& driver, QWidget* parent);

}  // namespace surefoot
