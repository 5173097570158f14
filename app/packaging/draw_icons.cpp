// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the icon in the sizes of a desktop: surefoot_icons ICON.svg FOLDER writes FOLDER/16.png … 512.png.
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  QSvgRenderer icon(QString::fromLocal8Bit(argv[1]));
  for (const int size : {16, 22, 24, 32, 48, 64, 128, 256, 512}) {
    QImage picture(size, size, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    icon.render(&painter);
    painter.end();
    if (icon.isValid() && picture.save(QStringLiteral("%1/%2.png").arg(QString::fromLocal8Bit(argv[2])).arg(size)))
      continue;
    std::fprintf(stderr, "surefoot_icons: %s cannot be drawn into %s.\n", argv[1], argv[2]);
    return 3;
  }
  return 0;
}
