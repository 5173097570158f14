// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a row of the list of lessons, or the head of a chapter.
#pragma once

#include <QStyledItemDelegate>

#include "core/registry.h"

namespace surefoot {

class LessonRow final : public QStyledItemDelegate {
  Q_OBJECT

 public:
  /// Data of an item: its lesson's index (heads have none), the ShelvedLesson, its progress; of a head its note.
  enum Data { kLesson = Qt::UserRole + 1, kShelved, kDone, kReached, kNote, kFirst };
  LessonRow(const Registry& registry, QObject* parent) : QStyledItemDelegate(parent), registry_(registry) {}

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  void paintHead(QPainter& p, const QRectF& where, const QModelIndex& index, const struct Theme& t) const;
  const Registry& registry_;
};

}  // namespace surefoot
