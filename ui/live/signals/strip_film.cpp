// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/signals/strip_film.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/signals/footage.h"
#include "ui/live/signals/strip_painter.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr double kWidth = 960;   // of the strips before they are enlarged [px]
constexpr double kShown = 30.0;  // [s]

}  // namespace

QSize aboveStrips(QSize whole) {
  return {whole.width(), whole.height() - static_cast<int>(kStripShare * whole.height())};
}

Film withStrips(Film above, QSize whole, std::shared_ptr<const SignalTable> table, std::vector<Strip> strips,
                double step, const Theme& theme) {
  const std::int64_t frames = above.frames;
  return {whole, frames,
          [above = std::move(above), whole, table = std::move(table), strips = std::move(strips), step,
           &theme](std::int64_t frame) {
            QImage image(whole, QImage::Format_RGB32);
            image.fill(theme.panel);
            QPainter p(&image);
            p.drawImage(0, 0, above.picture(frame));
            const auto last = static_cast<std::int64_t>(table->rows()) - 1;
            const auto row = std::clamp<std::int64_t>(
                static_cast<std::int64_t>(static_cast<double>(frame) / kFilmRate / step + 1e-9), 0,
                std::max<std::int64_t>(0, last));
            const std::vector<double>& time = table->columns()[0];
            const double end = time.empty() ? 1.0 : time.back() + 1e-9,
                         unit = end / (static_cast<double>(last + 1) * step);
            const double length = std::min(end, kShown * unit);
            const double from =
                time.empty() ? 0.0 : std::clamp(time[static_cast<std::size_t>(row)] - length / 2, 0.0, end - length);
            const StripPicture what{.table = table.get(),
                                    .strips = strips,
                                    .from = from,
                                    .to = from + length,
                                    .row = static_cast<std::size_t>(row),
                                    .learner = theme.ink,
                                    .clock = unit > 0.9 && unit < 1.1};
            const double enlarged = whole.width() / kWidth;
            const int top = aboveStrips(whole).height();
            p.translate(0, top);
            p.scale(enlarged, enlarged);
            StripPainter(theme, what, QRectF(0, 0, kWidth, (whole.height() - top) / enlarged)).paint(p);
            return image;
          }};
}

}  // namespace surefoot
