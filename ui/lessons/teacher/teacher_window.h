// SPDX-License-Identifier: GPL-3.0-or-later
// The teacher's window, for the screen that the class does not see: what the step is about, how long it should take and
// has taken, the answer, what to ask, what comes next; and what the class has answered, as it comes in.
#pragma once

#include <QDialog>
#include <QElapsedTimer>
#include <QTimer>

#include "core/lessons/handed_in/class_table.h"
#include "ui/support/background.h"

class QLabel;
class QTableWidget;
class QVBoxLayout;

namespace surefoot {

class TeacherWindow final : public QDialog {
  Q_OBJECT

 public:
  /// `classFolder`: where the class's answers come in; empty: there is no class.
  TeacherWindow(Lesson lesson, QString classFolder, QWidget* parent = nullptr);
  /// The lesson that is shown is at this step (from 0), for so long [s].
  void follow(std::size_t step, double seconds);
  /// The table of the class, as it is shown: rows are students, columns are steps.
  const QTableWidget& table() const { return *table_; }
  QString notes() const;

 private:
  QLabel* addText(QVBoxLayout& column, int pixels, int weight, bool quiet);
  void makeTable(QVBoxLayout& column);
  void tick();
  void read();
  void show(const ClassTable& table);

  const Lesson lesson_;
  const QString folder_;
  std::size_t step_ = 0;
  QElapsedTimer inStep_;
  double before_ = 0;  // in the step before it was followed [s]
  QTimer ticking_;
  QLabel *title_, *time_, *say_, *answer_, *hint_, *notes_, *next_, *most_, *state_;
  QTableWidget* table_ = nullptr;
  ClassTable class_;
  Background reading_;
};

/// The right answer of a step in the teacher's words: "2 Near the edge …", "ε = 0.3, again, 200 episodes".
QString answerOf(const LessonStep& step);

}  // namespace surefoot
