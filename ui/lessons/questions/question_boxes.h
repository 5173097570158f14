// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of questions but the prediction and the options, each with its controls.
#pragma once

#include <QCoreApplication>
#include "ui/lessons/questions/question_box.h"

class QLineEdit;
class QListWidget;
class QPlainTextEdit;

namespace surefoot {

class NumberBox final : public QuestionBox {
  Q_DECLARE_TR_FUNCTIONS(surefoot::NumberBox)

 public:
  NumberBox(LessonDriver& driver, const NumberQuestion& question, QWidget* parent);
  void check() override;

 private:
  QLineEdit* number_;
};

/// The options in an order of one's own: ↑ and ↓ with Alt, the buttons, or a drag move one.
class OrderBox final : public QuestionBox {
  Q_DECLARE_TR_FUNCTIONS(surefoot::OrderBox)

 public:
  OrderBox(LessonDriver& driver, const OrderQuestion& question, QWidget* parent);
  void check() override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void move(int by);
  std::vector<std::size_t> order() const;  ///< places in the file, from 0
  void keep();
  QListWidget* list_;
};

/// A place on the map, a fall or an action: answered by a click there.
class PointBox final : public QuestionBox {
  Q_DECLARE_TR_FUNCTIONS(surefoot::PointBox)

 public:
  PointBox(LessonDriver& driver, const PointQuestion& question, QWidget* parent);
};

/// Own words, and then a model answer beside them.
class WordsBox final : public QuestionBox {
  Q_DECLARE_TR_FUNCTIONS(surefoot::WordsBox)

 public:
  WordsBox(LessonDriver& driver, const WordsQuestion& question, QWidget* parent);
  void check() override;

 private:
  QPlainTextEdit* text_;
  QWidget* model_;
};

/// A task that ticks itself.
class TaskBox final : public QuestionBox {
  Q_DECLARE_TR_FUNCTIONS(surefoot::TaskBox)

 public:
  TaskBox(LessonDriver& driver, QWidget* parent);

 private:
  void refresh();
  QLabel *task_, *par_;
};

}  // namespace surefoot
