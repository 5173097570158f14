// SPDX-License-Identifier: GPL-3.0-or-later
// The chosen lesson, beside the list: its picture, what it is about, its steps, and the buttons that begin it. It gives
// no answer away.
#pragma once

#include <QWidget>

#include "ui/lessons/lesson_list.h"

class QHBoxLayout;
class QScrollArea;
class QVBoxLayout;

namespace surefoot {

class LessonDetails final : public QWidget {
  Q_OBJECT

 public:
  explicit LessonDetails(const Registry& registry, QWidget* parent = nullptr);
  void show(const ListedLesson& listed, const std::vector<ListedLesson>& all);

 Q_SIGNALS:
  void startAsked();
  void beginAgainAsked();
  void exploreAsked();

 private:
  void showError(const ShelvedLesson& shelved);
  void showLesson(const ListedLesson& listed, const std::vector<ListedLesson>& all);
  void addFacts(const Lesson& lesson, const std::vector<ListedLesson>& all);
  void addButtons(const ListedLesson& listed);
  void addRow(const QString& first, const QString& words, const QString& last, bool quietFirst);
  void addLine();

  const Registry& registry_;
  QScrollArea* scroll_;
  QHBoxLayout* buttons_;
  QVBoxLayout* column_ = nullptr;
};

}  // namespace surefoot
