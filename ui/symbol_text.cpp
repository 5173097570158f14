// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/symbol_text.h"

#include <QFontMetricsF>

namespace surefoot {

namespace {
constexpr QChar kDot(0x0307);
constexpr double kDotRadius = 1.05, kDotAbove = 2.3;  // [px] at 13 px text
}  // namespace

double symbolWidth(const QFont& font, const QString& text) {
  QString plain = text;
  plain.remove(kDot);
  return QFontMetricsF(font).horizontalAdvance(plain);
}

void drawSymbol(QPainter& painter, double x, double y, const QString& text) {
  const QFontMetricsF metrics(painter.font());
  QString plain;
  for (const QChar c : text) {
    if (c != kDot) {
      plain += c;
      continue;
    }
    const QChar letter = plain.back();
    const double left = x + metrics.horizontalAdvance(plain.chopped(1));
    const double middle = left + metrics.horizontalAdvance(letter) / 2;
    const double top = metrics.tightBoundingRect(letter).top();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(painter.pen().color());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(QPointF(middle, y + top - kDotAbove), kDotRadius, kDotRadius);
    painter.restore();
  }
  painter.drawText(QPointF(x, y), plain);
}

void drawSymbol(QPainter& painter, const QRectF& where, Qt::Alignment alignment, const QString& text) {
  const double width = symbolWidth(painter.font(), text);
  double x = where.left();
  if (alignment & Qt::AlignRight) x = where.right() - width;
  if (alignment & Qt::AlignHCenter) x = where.center().x() - width / 2;
  const QFontMetricsF metrics(painter.font());
  drawSymbol(painter, x, where.center().y() + (metrics.ascent() - metrics.descent()) / 2, text);
}

void drawMarker(QPainter& painter, QPointF c, const PolicyLook& look, bool filled) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(look.colour, 1.5));
  painter.setBrush(filled ? QBrush(look.colour) : QBrush(Qt::NoBrush));
  switch (look.marker) {
    case Marker::Circle:
      painter.drawEllipse(c, 3.5, 3.5);
      break;
    case Marker::Square:
      painter.drawRect(QRectF(c.x() - 3, c.y() - 3, 6, 6));
      break;
    case Marker::Triangle:
      painter.drawPolygon(QPolygonF({{c.x() - 4, c.y() + 3}, {c.x(), c.y() - 4}, {c.x() + 4, c.y() + 3}}));
      break;
    case Marker::Diamond:
      painter.drawPolygon(QPolygonF({{c.x() - 4, c.y()}, {c.x(), c.y() - 4}, {c.x() + 4, c.y()}, {c.x(), c.y() + 4}}));
      break;
  }
  painter.restore();
}

}  // namespace surefoot
