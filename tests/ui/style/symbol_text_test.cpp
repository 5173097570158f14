// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/symbol_text.h"

#include <gtest/gtest.h>

#include <QFontMetrics>
#include <QImage>

namespace surefoot {

namespace {

/// Columns of an image that hold any ink, in the rows above `below`.
QList<int> inkedColumns(const QString& text, int below) {
  QImage image(40, 30, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter p(&image);
  p.setFont(textFont(13));
  p.setPen(Qt::black);
  drawSymbol(p, 10, 22, text);
  p.end();
  QList<int> columns;
  for (int x = 0; x < image.width(); ++x)
    for (int y = 0; y < below; ++y)
      if (qGray(image.pixel(x, y)) < 128) {
        columns << x;
        break;
      }
  return columns;
}

}  // namespace

TEST(SymbolText, DrawsTheDotAboveItsLetter) {
  const int top = 22 - QFontMetrics(textFont(13)).tightBoundingRect("α").height() - 1;
  EXPECT_TRUE(inkedColumns(QStringLiteral("α"), top).isEmpty());
  const QList<int> dot = inkedColumns(QStringLiteral("α\u0307"), top);
  ASSERT_FALSE(dot.isEmpty());
  const double middle = 10 + QFontMetricsF(textFont(13)).horizontalAdvance("α") / 2;
  EXPECT_NEAR((dot.front() + dot.back()) / 2.0, middle, 1.5);
}

TEST(SymbolText, TheDotTakesNoWidth) {
  EXPECT_EQ(symbolWidth(textFont(13), QStringLiteral("α\u0307 [rad/s]")),
            symbolWidth(textFont(13), QStringLiteral("α [rad/s]")));
}

TEST(TextFont, HasDigitsOfOneWidth) {
  const QFontMetrics metrics(textFont(13));
  for (char digit = '0'; digit <= '9'; ++digit)
    EXPECT_EQ(metrics.horizontalAdvance(digit), metrics.horizontalAdvance('0'));
}

}  // namespace surefoot
