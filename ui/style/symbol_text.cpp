// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/symbol_text.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>
#include <vector>

namespace surefoot {

namespace {

constexpr QChar kDot(0x0307), kLow('_');
constexpr double kDotRadius = 1.05, kDotAbove = 2.3;  // [px] at 13 px text
constexpr double kSubscript = 0.75, kDown = 0.22;     // size of a subscript, and how far below the baseline it stands

/// A stretch of text with its size: "U_h" is a U and a small, low h.
struct Piece {
  QString text;
  bool low = false;
};

/// Whether a "_" stands between one letter and one letter or digit; not so in a key ("swing_hip").
bool lowersNext(const QString& text, qsizetype i) {
  const auto isWord = [&](qsizetype at) {
    return at >= 0 && at < text.size() && (text[at].isLetterOrNumber() || text[at] == kLow);
  };
  return text[i] == kLow && isWord(i - 1) && !isWord(i - 2) && isWord(i + 1) && !isWord(i + 2);
}

std::vector<Piece> piecesOf(const QString& text) {
  std::vector<Piece> pieces(1);
  for (qsizetype i = 0; i < text.size(); ++i) {
    if (lowersNext(text, i)) {
      pieces.push_back({text.mid(++i, 1), true});
      pieces.emplace_back();
    } else {
      pieces.back().text += text[i];
    }
  }
  return pieces;
}

QFont lowFont(QFont font) {
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(kSubscript * font.pixelSize()))));
  return font;
}

double plainWidth(const QFont& font, QString text) {
  return QFontMetricsF(font).horizontalAdvance(text.remove(kDot));
}

/// Without subscripts.
void drawPlain(QPainter& painter, double x, double y, const QString& text) {
  const QFontMetricsF metrics(painter.font());
  QString plain;
  for (const QChar c : text) {
    if (c != kDot || plain.isEmpty()) {
      plain += c;
      continue;
    }
    const QChar letter = plain.back();
    const double left = x + metrics.horizontalAdvance(plain.chopped(1));
    const double middle = left + metrics.horizontalAdvance(letter) / 2;
    const double top = metrics.tightBoundingRect(letter).top(), k = textScale();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(painter.pen().color());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(QPointF(middle, y + top - kDotAbove * k), kDotRadius * k, kDotRadius * k);
    painter.restore();
  }
  painter.drawText(QPointF(x, y), plain);
}

}  // namespace

QString plainSymbols(QString text) {
  for (qsizetype i = text.size() - 1; i > 0; --i)
    if (lowersNext(text, i)) text.remove(i, 1);
  return text;
}

double symbolWidth(const QFont& font, const QString& text) {
  if (!text.contains(kLow)) return plainWidth(font, text);
  double width = 0;
  for (const Piece& piece : piecesOf(text)) width += plainWidth(piece.low ? lowFont(font) : font, piece.text);
  return width;
}

void drawSymbol(QPainter& painter, double x, double y, const QString& text) {
  if (!text.contains(kLow)) return drawPlain(painter, x, y, text);
  const QFont font = painter.font();
  for (const Piece& piece : piecesOf(text)) {
    painter.setFont(piece.low ? lowFont(font) : font);
    drawPlain(painter, x, y + (piece.low ? kDown * font.pixelSize() : 0), piece.text);
    x += plainWidth(painter.font(), piece.text);
  }
  painter.setFont(font);
}

void drawSymbol(QPainter& painter, const QRectF& where, Qt::Alignment alignment, const QString& text) {
  const double width = symbolWidth(painter.font(), text);
  double x = where.left();
  if (alignment & Qt::AlignRight) x = where.right() - width;
  if (alignment & Qt::AlignHCenter) x = where.center().x() - width / 2;
  const QFontMetricsF metrics(painter.font());
  drawSymbol(painter, x, where.center().y() + (metrics.ascent() - metrics.descent()) / 2, text);
}

}  // namespace surefoot
