// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lesson_list.h"

#include <QKeyEvent>
#include <QStandardItemModel>

#include "ui/lessons/lesson_row.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

/// "Lesson 6 of 12, The cliff: Sarsa or Q-learning, 10 minutes, level 2 of 3, not begun".
QString spoken(const ListedLesson& listed, int of) {
  if (!listed.shelved->lesson) return LessonList::tr("%1, it has an error").arg(toText(listed.shelved->file()));
  const Lesson& lesson = *listed.shelved->lesson;
  const QString state = listed.done >= 1 ? LessonList::tr("done")
                        : listed.done > 0
                            ? LessonList::tr("step %1 of %2").arg(listed.reached + 1).arg(lesson.steps.size())
                            : LessonList::tr("not begun");
  const QString place =
      lesson.number.empty() ? QString() : LessonList::tr("Lesson %1 of %2, ").arg(toText(lesson.number)).arg(of);
  return LessonList::tr("%1%2, %3 minutes, level %4 of 3, %5")
      .arg(place, toText(lesson.title))
      .arg(lesson.minutes)
      .arg(lesson.level)
      .arg(state);
}

}  // namespace

LessonList::LessonList(const Registry& registry, QWidget* parent)
    : QListView(parent),
      model_(new QStandardItemModel(this)) {
  setModel(model_);
  setItemDelegate(new LessonRow(registry, this));
  setFrameShape(QFrame::NoFrame);
  setEditTriggers(NoEditTriggers);
  setVerticalScrollMode(ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setAccessibleName(tr("Lessons"));
  setMouseTracking(true);
  whenScaled(this, [this] { scheduleDelayedItemsLayout(); });
  connect(this, &QListView::doubleClicked, this, [this](const QModelIndex& index) {
    if (const QVariant lesson = index.data(LessonRow::kLesson); lesson.isValid()) Q_EMIT startAsked(lesson.toInt());
  });
}

void LessonList::show(const std::vector<ListedLesson>& lessons) {
  const int before = chosen();
  model_->clear();
  std::string chapter;
  int numbered = 0;
  for (const ListedLesson& listed : lessons)
    numbered += listed.shelved->lesson && !listed.shelved->lesson->number.empty();
  for (std::size_t i = 0; i < lessons.size(); ++i) {
    const auto& lesson = lessons[i].shelved->lesson;
    const std::string own = lesson ? lesson->chapter : chapter;
    if (own != chapter || i == 0) {
      int all = 0, done = 0;
      for (const ListedLesson& other : lessons) {
        if (!other.shelved->lesson || other.shelved->lesson->chapter != own) continue;
        ++all, done += other.done >= 1;
      }
      auto* head = new QStandardItem(toText(own));
      head->setFlags(Qt::NoItemFlags);
      head->setData(tr("%1 of %2").arg(done).arg(all), LessonRow::kNote);
      head->setData(i == 0, LessonRow::kFirst);
      model_->appendRow(head);
      chapter = own;
    }
    auto* row = new QStandardItem(lesson ? toText(lesson->title) : toText(lessons[i].shelved->file()));
    row->setData(static_cast<int>(i), LessonRow::kLesson);
    row->setData(QVariant::fromValue<const void*>(lessons[i].shelved), LessonRow::kShelved);
    row->setData(lessons[i].done, LessonRow::kDone);
    row->setData(static_cast<int>(lessons[i].reached), LessonRow::kReached);
    row->setData(spoken(lessons[i], numbered), Qt::AccessibleTextRole);
    model_->appendRow(row);
  }
  choose(before);
}

int LessonList::chosen() const {
  const QVariant lesson = currentIndex().data(LessonRow::kLesson);
  return lesson.isValid() ? lesson.toInt() : -1;
}

void LessonList::choose(int lesson) {
  for (int row = 0; row < model_->rowCount(); ++row)
    if (const QVariant own = model_->index(row, 0).data(LessonRow::kLesson); own.isValid() && own.toInt() == lesson)
      return setCurrentIndex(model_->index(row, 0));
}

void LessonList::currentChanged(const QModelIndex& current, const QModelIndex& before) {
  QListView::currentChanged(current, before);
  if (chosen() >= 0) Q_EMIT chosenChanged(chosen());
}

void LessonList::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter && chosen() >= 0) return Q_EMIT startAsked(chosen());
  if (event->key() == Qt::Key_Home) return choose(0);
  QListView::keyPressEvent(event);
}

void LessonList::changeEvent(QEvent* event) {
  QListView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) viewport()->update();
}

}  // namespace surefoot

#include "moc_lesson_list.cpp"
