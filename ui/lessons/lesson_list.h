// SPDX-License-Identifier: GPL-3.0-or-later
// The list of lessons in chapters: number, picture, title and line, minutes, level, progress. ↑ ↓ choose, letters seek
// a title, Enter or a double click starts.
#pragma once

#include <QListView>
#include <QPixmap>
#include <vector>

#include "core/lessons/reading/lesson_library.h"

class QStandardItemModel;

namespace surefoot {

/// A lesson as the list shows it.
struct ListedLesson {
  const ShelvedLesson* shelved;
  double done = 0.0;        ///< 0 to 1
  std::size_t reached = 0;  ///< the step in hand, from 0
};

class LessonList final : public QListView {
  Q_OBJECT

 public:
  explicit LessonList(const Registry& registry, QWidget* parent = nullptr);
  void show(const std::vector<ListedLesson>& lessons);
  /// The index of the chosen lesson; −1: none.
  int chosen() const;
  void choose(int lesson);

 Q_SIGNALS:
  void chosenChanged(int lesson);
  void startAsked(int lesson);

 protected:
  void currentChanged(const QModelIndex& current, const QModelIndex& before) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QStandardItemModel* model_;
};

}  // namespace surefoot
