// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/signals/strip_film.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/film/world_film.h"
#include "ui/live/signals/strip_painter.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr double kWidth = 960;   // of the strips before they are enlarged [px]
constexpr double kShown = 30.0;  // [s]
/// The share of a film's height that is the strips', and as much as many strips may have.
constexpr double kStripShare = 0.42, kMostStripShare = 0.55;

/// The time that a film shows: of its rows.
std::pair<double, double> timeOf(const std::vector<std::int64_t>& rows, const SignalTable& table) {
  const std::vector<double>& time = table.columns()[0];
  const auto first = std::find_if(rows.begin(), rows.end(), [](std::int64_t row) { return row >= 0; });
  if (first == rows.end()) return {time.front(), time.back() + table.stepTime()};
  const auto last = static_cast<std::size_t>(*std::max_element(rows.begin(), rows.end()));
  return {time[static_cast<std::size_t>(*first)], std::min(time.back(), time[last] + 1 / kFilmRate) + table.stepTime()};
}

/// The strips as they are at a row; −1: there is no cursor.
StripPicture pictureAt(std::int64_t row, std::pair<double, double> filmed, const StripsBelow& below,
                       const Theme& theme) {
  const SignalTable& table = *below.table;
  const bool clock = table.signals()[0].unit == "s";
  const auto [first, end] = filmed;
  const double length = std::min(end - first, clock ? kShown : kShown / kUnclockedStep);
  const double moment = row < 0 ? first : table.columns()[0][static_cast<std::size_t>(row)];
  const double from = std::clamp(moment - length / 2, first, std::max(first, end - length));
  return {.table = &table,
          .strips = below.strips,
          .from = from,
          .to = from + length,
          .row = row < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(row)),
          .learner = theme.ink,
          .clock = clock};
}

/// Many strips get more of the height; where that is not enough, they are drawn smaller.
QSize aboveStrips(QSize whole, double least) {
  const double wanted = least * whole.width() / kWidth / whole.height();
  return {whole.width(),
          whole.height() - static_cast<int>(std::clamp(wanted, kStripShare, kMostStripShare) * whole.height())};
}

}  // namespace

Film filmOf(std::shared_ptr<const Environment> environment, Footage footage, StripsBelow below, QSize whole,
            const Theme& theme) {
  if (below.strips.empty() || !below.table || below.table->rows() == 0)
    return worldFilm(std::move(environment), std::move(footage), whole, theme);
  std::vector<std::int64_t> rows = footage.rows;
  for (std::int64_t& row : rows) row = std::min(row, static_cast<std::int64_t>(below.table->rows()) - 1);
  const auto filmed = timeOf(rows, *below.table);
  const double least = StripPainter::leastHeight(pictureAt(-1, filmed, below, theme));
  const QSize upper = aboveStrips(whole, least);
  const double enlarged = std::min(whole.width() / kWidth, (whole.height() - upper.height()) / least);
  Film above = worldFilm(std::move(environment), std::move(footage), upper, theme);
  const std::int64_t frames = above.frames;
  return {whole, frames,
          [above = std::move(above), rows = std::move(rows), below = std::move(below), filmed, whole, upper, enlarged,
           &theme](std::int64_t frame) {
            QImage image(whole, QImage::Format_RGB32);
            image.fill(theme.panel);
            QPainter p(&image);
            p.drawImage(0, 0, above.picture(frame));
            const StripPicture what = pictureAt(rows[static_cast<std::size_t>(frame)], filmed, below, theme);
            p.translate(0, upper.height());
            p.scale(enlarged, enlarged);
            const QSizeF room = QSizeF(whole.width(), whole.height() - upper.height()) / enlarged;
            StripPainter(theme, what, QRectF(QPointF(), room)).paint(p);
            return image;
          }};
}

}  // namespace surefoot
