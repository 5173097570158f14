// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

namespace surefoot {

/// How many pixels of an image, or of a part of it, have a colour.
inline int pixelsOf(const QImage& image, const QColor& colour, QRect where = {}) {
  if (where.isNull()) where = image.rect();
  int count = 0;
  for (int y = where.top(); y <= where.bottom(); ++y)
    for (int x = where.left(); x <= where.right(); ++x) count += image.pixel(x, y) == colour.rgb();
  return count;
}

}  // namespace surefoot
