// SPDX-License-Identifier: GPL-3.0-or-later
// The questions with a few options, of which one is chosen.
#pragma once

#include <QCoreApplication>
#include <functional>

#include "ui/lessons/questions/question_box.h"

class QButtonGroup;
class QPlainTextEdit;

namespace surefoot {

/// One of a few options. A key 1, 2, 3 … chooses one, Enter gives the answer.
class OptionsBox : public QuestionBox {
  Q_DECLARE_TR_FUNCTIONS(surefoot::OptionsBox)

 protected:
  using QuestionBox::QuestionBox;
  void addOptions(const QStringList& options);
  int chosen() const;  ///< from 0; −1: none
  void choose(int option);
  void keepWhenChosen(const std::function<void()>& keep);
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QButtonGroup* options_ = nullptr;
};

/// "Because" is kept, never marked.
class ChoiceBox final : public OptionsBox {
  Q_DECLARE_TR_FUNCTIONS(surefoot::ChoiceBox)

 public:
  ChoiceBox(LessonDriver& driver, const ChoiceQuestion& question, QWidget* parent);
  void check() override;

 private:
  void keep();
  QPlainTextEdit* because_ = nullptr;
};

/// Which of two ways fell less, by their lives.
class CompareBox final : public OptionsBox {
  Q_DECLARE_TR_FUNCTIONS(surefoot::CompareBox)

 public:
  CompareBox(LessonDriver& driver, const CompareQuestion& question, QWidget* parent);
  void check() override;
};

}  // namespace surefoot
