// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of questions but the prediction, each with its controls.
#pragma once

#include "ui/lessons/taking/question_box.h"

class QButtonGroup;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;

namespace surefoot {

/// One of a few options; "because" is kept, never marked.
class ChoiceBox final : public QuestionBox {
  Q_OBJECT

 public:
  ChoiceBox(LessonDriver& driver, const ChoiceQuestion& question, QWidget* parent);
  QWidget* first() override;
  void check() override;
  QString nextWord() const override { return tr("Check"); }

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QButtonGroup* options_;
  QPlainTextEdit* because_ = nullptr;
};

class NumberBox final : public QuestionBox {
  Q_OBJECT

 public:
  NumberBox(LessonDriver& driver, const NumberQuestion& question, QWidget* parent);
  QWidget* first() override;
  void check() override;
  QString nextWord() const override { return tr("Check"); }

 private:
  QLineEdit* number_;
};

/// The options in an order of one's own: ↑ and ↓ with Alt, the buttons, or a drag move one.
class OrderBox final : public QuestionBox {
  Q_OBJECT

 public:
  OrderBox(LessonDriver& driver, const OrderQuestion& question, QWidget* parent);
  QWidget* first() override;
  void check() override;
  QString nextWord() const override { return tr("Check"); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void move(int by);
  QListWidget* list_;
};

/// A place on the map, a fall or an action: answered by a click there.
class PointBox final : public QuestionBox {
  Q_OBJECT

 public:
  PointBox(LessonDriver& driver, const PointQuestion& question, QWidget* parent);
  QWidget* first() override { return this; }

 private:
  QListWidget* actions_ = nullptr;
};

/// Own words, and then a model answer beside them.
class WordsBox final : public QuestionBox {
  Q_OBJECT

 public:
  WordsBox(LessonDriver& driver, const WordsQuestion& question, QWidget* parent);
  QWidget* first() override;
  void check() override;
  QString nextWord() const override { return tr("Keep it"); }

 private:
  QPlainTextEdit* text_;
  QWidget* model_;
};

class CompareBox final : public QuestionBox {
  Q_OBJECT

 public:
  CompareBox(LessonDriver& driver, const CompareQuestion& question, QWidget* parent);
  QWidget* first() override;
  void check() override;
  QString nextWord() const override { return tr("Check"); }

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QButtonGroup* options_;
};

/// A task that ticks itself.
class TaskBox final : public QuestionBox {
  Q_OBJECT

 public:
  TaskBox(LessonDriver& driver, QWidget* parent);
  QWidget* first() override { return this; }

 private:
  void refresh();
  QLabel *task_, *par_;
};

}  // namespace surefoot
