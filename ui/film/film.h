// SPDX-License-Identifier: GPL-3.0-or-later
// A film as a function: a picture for every number. So what is painted knows nothing of how it is encoded, and one film
// can be put below another.
#pragma once

#include <QImage>
#include <functional>

namespace surefoot {

/// 30 pictures a second (kFilmRate).
struct Film {
  QSize size;  ///< [px]
  std::int64_t frames = 0;
  /// The picture of a number from 0 to frames − 1, of this size; the same number gives the same bits. Any thread, one
  /// at a time.
  std::function<QImage(std::int64_t frame)> picture;
};

}  // namespace surefoot
