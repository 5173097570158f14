// SPDX-License-Identifier: GPL-3.0-or-later
// The column of a lesson: title and dots, the text of the step, its question and knobs; below them hint, reset, explore
// freely, Back and Next. What is between scrolls.
#pragma once

#include <QPointer>
#include <QWidget>

#include "ui/lessons/driver/lesson_driver.h"
#include "ui/lessons/taking/knob_rows.h"

class QLabel;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace surefoot {

class MarkdownView;
class QuestionBox;
class StepDots;
class TextButton;

class LessonColumn final : public QWidget {
  Q_OBJECT

 public:
  explicit LessonColumn(LessonDriver& driver, QWidget* parent = nullptr);
  QuestionBox* question() const { return question_; }
  void goOn();
  void goBack();
  void showHint();
  void focusFirst();
  void setNext(const QString& name, const QString& title) { nextName_ = name, nextTitle_ = title; }

 Q_SIGNALS:
  void exploreAsked();
  void lessonAsked(const QString& name);
  void nextLessonAsked();
  void predictionMoved(double value);
  void refused(const QString& sentence);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void makeFoot(QVBoxLayout& column);
  void showStep();
  void showEnd();
  void refresh();
  QString willMove() const;
  void orderTabs();
  QLabel* addText(const QString& text, int pixels, bool quiet);
  void addLine();
  QVBoxLayout& anew();

  LessonDriver& driver_;
  QString nextName_, nextTitle_;
  QLabel *title_, *number_;
  StepDots* dots_;
  QScrollArea* scroll_;
  QPointer<QWidget> content_;
  QVBoxLayout* column_ = nullptr;
  QPointer<MarkdownView> text_;
  QPointer<QuestionBox> question_;
  QPointer<QLabel> hint_, progress_;
  QPointer<KnobRows> knobs_;
  QToolButton *hintLink_, *reset_, *explore_;
  TextButton *back_, *next_;
};

}  // namespace surefoot
