// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/labels.h"

#include <QEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QStyle>

#include "ui/style/scale.h"
#include "ui/style/theme.h"

namespace surefoot {

QString unbroken(QString text) {
  static const QRegularExpression kSign(QStringLiteral(" ([=·×+−<>≤≥]) "));
  static const QRegularExpression kLead(QStringLiteral("([×≈]) (?=[\\d−])"));
  static const QRegularExpression kPair(QStringLiteral("\\((\\S{1,2}), (\\S{1,6})\\)"));
  const QString hard(QChar(0xa0));
  text.replace(kSign, hard + QStringLiteral("\\1") + hard);
  text.replace(kLead, QStringLiteral("\\1") + hard);
  return text.replace(kPair, QStringLiteral("(\\1,") + hard + QStringLiteral("\\2)"));
}

QLabel* makeText(const QString& text, int pixels, int weight, bool quiet, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setTextFormat(Qt::PlainText);
  if (quiet) label->setForegroundRole(QPalette::PlaceholderText);
  whenScaled(label, [label, pixels, weight] { label->setFont(scaledFont(pixels, weight)); });
  return label;
}

OneLine::OneLine(int pixels, QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setForegroundRole(QPalette::PlaceholderText);
  whenScaled(this, [this, pixels] { setFont(scaledFont(pixels, 400)); });
}

void OneLine::paintEvent(QPaintEvent*) {
  QPainter p(this);
  const QRect room = contentsRect();
  style()->drawItemText(&p, room, Qt::AlignLeft | Qt::AlignVCenter, palette(), isEnabled(),
                        fontMetrics().elidedText(text(), Qt::ElideRight, room.width()), foregroundRole());
}

QLabel* makeHead(const QString& text, QWidget* parent) {
  auto* head = new QLabel(text.toUpper(), parent);
  head->setForegroundRole(QPalette::PlaceholderText);
  head->setAccessibleName(text);
  whenScaled(head, [head] {
    QFont font = scaledFont(11, 500);
    font.setLetterSpacing(QFont::PercentageSpacing, 106);
    head->setFont(font);
  });
  return head;
}

FallLabel::FallLabel(int pixels, int weight, QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  whenScaled(this, [this, pixels, weight] { setFont(scaledFont(pixels, weight)); });
  QEvent first(QEvent::PaletteChange);
  FallLabel::changeEvent(&first);
}

void FallLabel::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  QPalette falls = palette();
  if (falls.color(QPalette::WindowText) == themeOf(*this).fallText) return;
  falls.setColor(QPalette::WindowText, themeOf(*this).fallText);
  setPalette(falls);
}

}  // namespace surefoot
