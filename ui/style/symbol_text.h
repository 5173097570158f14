// SPDX-License-Identifier: GPL-3.0-or-later
// Text with dotted letters (α̇, β̇) and subscripts ("U_h"). Combining dots stand in the wrong place in most fonts, so
// the dot is drawn.
#pragma once

#include <QPainter>
#include <QString>
#include <string>

#include "ui/style/theme.h"

namespace surefoot {

/// Width of the text, a U+0307 counting nothing, a letter or digit behind a "_" as a subscript [px].
double symbolWidth(const QFont& font, const QString& text);

/// Draws with the painter's pen and font; x, y are the left end of the baseline.
void drawSymbol(QPainter& painter, double x, double y, const QString& text);

/// Draws the text in a rectangle, aligned as Qt::AlignLeft, AlignHCenter or AlignRight, centred vertically.
void drawSymbol(QPainter& painter, const QRectF& where, Qt::Alignment alignment, const QString& text);

/// How many times larger than usual texts are.
inline double textScale() {
  return textFont(100).pixelSize() / 100.0;
}

/// For a menu or a box, which draw text themselves: a dotted letter without its dot, a subscript beside its letter.
QString plainSymbols(QString text);

inline QString toText(const std::string& text) {
  return QString::fromStdString(text);
}

}  // namespace surefoot
