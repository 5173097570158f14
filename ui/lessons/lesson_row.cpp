// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lesson_row.h"

#include <QPainter>

#include "core/lessons/reading/lesson_library.h"
#include "ui/lessons/lesson_picture.h"
#include "ui/lessons/taking/step_dots.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr int kRow = 40, kHead = 32, kGap = 8;               // [px]
constexpr double kRight = 24, kRing = 12;                    // from the right edge of the row [px]
constexpr double kLevel = 120, kMinutes = 204, kSteps = 52;  // right ends of the columns, from the right edge [px]

void drawLevel(QPainter& p, const QPointF& first, int level, const Theme& t) {
  for (int i = 0; i < 3; ++i) {
    p.setPen(QPen(i < level ? t.ink : t.quiet, 1));
    p.setBrush(i < level ? QBrush(t.ink) : QBrush(Qt::NoBrush));
    p.drawEllipse(first + QPointF(10 * i, 0), 2.75, 2.75);
  }
}

}  // namespace

QSize LessonRow::sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const {
  const bool head = !index.data(kLesson).isValid();
  const bool gap = head && !index.data(kFirst).toBool();
  return scaled(QSize(400, head ? kHead + (gap ? kGap : 0) : kRow));
}

void LessonRow::paintHead(QPainter& p, const QRectF& where, const QModelIndex& index, const Theme& t) const {
  if (!index.data(kFirst).toBool()) {
    p.setPen(QPen(t.hairline, 1));
    p.drawLine(QPointF(12, where.top() + kGap - 0.5), QPointF(where.right() - 12, where.top() + kGap - 0.5));
  }
  QFont font = textFont(11, 500);
  font.setLetterSpacing(QFont::PercentageSpacing, 106);
  p.setFont(font);
  p.setPen(t.quiet);
  const QRectF line(12, where.bottom() - kHead, where.width() - 24, kHead);
  p.drawText(line, Qt::AlignVCenter | Qt::AlignLeft, index.data().toString().toUpper());
  p.setFont(textFont(11));
  p.drawText(line, Qt::AlignVCenter | Qt::AlignRight, index.data(kNote).toString());
  if (!index.data(kFirst).toBool()) return;
  const double right = where.right();
  p.drawText(QRectF(right - kMinutes - 80, line.top(), 80, kHead), Qt::AlignVCenter | Qt::AlignRight, tr("minutes"));
  p.drawText(QRectF(right - kLevel - 34, line.top(), 40, kHead), Qt::AlignVCenter | Qt::AlignLeft, tr("level"));
}

void LessonRow::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const Theme& t = themeOf(option.palette);
  QPainter& p = *painter;
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.scale(textSize(), textSize());
  const QRectF where(QPointF(option.rect.topLeft()) / textSize(), QSizeF(option.rect.size()) / textSize());
  if (!index.data(kLesson).isValid()) {
    paintHead(p, where, index, t);
    return p.restore();
  }
  const bool chosen = option.state & QStyle::State_Selected;
  if (chosen || option.state & QStyle::State_MouseOver) {
    QColor fill = t.fill;
    if (!chosen) fill.setAlphaF(0.5f);
    p.setPen(Qt::NoPen);
    p.setBrush(fill);
    p.drawRoundedRect(where.adjusted(4, 0, -4, 0), 4, 4);
  }
  if (chosen && option.state & QStyle::State_HasFocus) {
    p.setPen(QPen(t.accent, 2));
    p.setBrush(Qt::NoBrush);
    p.drawRoundedRect(where.adjusted(5, 1, -5, -1), 4, 4);
  }
  const auto& shelved = *static_cast<const ShelvedLesson*>(index.data(kShelved).value<const void*>());
  const double top = where.top(), right = where.right();
  if (!shelved.lesson) {
    p.setFont(textFont(13, 500));
    p.setPen(t.caution);
    p.drawText(QRectF(116, top + 3, right - 140, 18), Qt::AlignVCenter, index.data().toString());
    p.setFont(textFont(11));
    p.drawText(QRectF(116, top + 21, right - 140, 16), Qt::AlignVCenter, tr("it has an error"));
    return p.restore();
  }
  const Lesson& lesson = *shelved.lesson;
  p.setFont(textFont(13, chosen ? 500 : 400));
  p.setPen(chosen ? t.ink : t.quiet);
  p.drawText(QRectF(8, top, 24, kRow), Qt::AlignVCenter | Qt::AlignRight, toText(lesson.number));
  drawLessonPicture(p, QRectF(44, top + 4, 56, 32), registry_, lesson, t);
  const double words = right - kMinutes - 116 - 32;
  p.setPen(t.ink);
  p.setFont(textFont(13, 500));
  p.drawText(QRectF(116, top + 3, words, 18), Qt::AlignVCenter,
             QFontMetricsF(p.font()).elidedText(toText(lesson.title), Qt::ElideRight, words));
  p.setPen(t.quiet);
  p.setFont(textFont(11));
  p.drawText(QRectF(116, top + 20, words, 16), Qt::AlignVCenter,
             QFontMetricsF(p.font()).elidedText(toText(lesson.line), Qt::ElideRight, words));
  p.setPen(t.ink);
  p.setFont(textFont(13));
  p.drawText(QRectF(right - kMinutes - 60, top, 60, kRow), Qt::AlignVCenter | Qt::AlignRight,
             QString::number(lesson.minutes));
  drawLevel(p, QPointF(right - kLevel - 31, top + kRow / 2.0), lesson.level, t);
  const double done = index.data(kDone).toDouble();
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  if (done > 0 && done < 1)
    p.drawText(QRectF(right - kSteps - 60, top, 60, kRow), Qt::AlignVCenter | Qt::AlignRight,
               tr("%1 of %2").arg(index.data(kReached).toInt() + 1).arg(lesson.steps.size()));
  drawProgressRing(p, QPointF(right - kRight - kRing + kRing, top + kRow / 2.0), done, chosen, t);
  p.restore();
}

}  // namespace surefoot

#include "moc_lesson_row.cpp"
