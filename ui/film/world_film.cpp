// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/world_film.h"

#include <algorithm>
#include <cmath>

#include "ui/live/world/world_picture.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr QSizeF kView(576, 400);  // [px]
constexpr double kOfWindow = 2;    // pictures of the window, at 60 a second, for one of a film
constexpr auto kFilmTrail = static_cast<std::size_t>(WorldPicture::kTrail / kOfWindow);

QImage paintedWorld(const Environment& environment, const Footage& footage, std::size_t frame, QSize size,
                    const Theme& theme) {
  WorldPicture world;
  for (std::size_t i = frame - std::min(frame, kFilmTrail - 1); i <= frame; ++i) {
    environment.draw(footage.poses[i], world.scene);
    world.follow(world.scene.tip, kFilmTrail, kOfWindow * WorldPicture::kJump);
  }
  world.readOuts = environment.readOuts(footage.poses[frame]);
  world.camera = world.scene.focus.x;
  QImage image(size, QImage::Format_RGB32);
  QPainter painter(&image);
  const double enlarged = std::min(size.width() / kView.width(), size.height() / kView.height());
  painter.scale(enlarged, enlarged);
  world.measure(
      {static_cast<int>(std::ceil(size.width() / enlarged)), static_cast<int>(std::ceil(size.height() / enlarged))});
  world.paint(painter, theme, footage.falls[frame] != 0);
  return image;
}

}  // namespace

Film worldFilm(std::shared_ptr<const Environment> environment, Footage footage, QSize size, const Theme& theme) {
  const auto frames = static_cast<std::int64_t>(footage.poses.size());
  return {size, frames,
          [environment = std::move(environment), footage = std::make_shared<const Footage>(std::move(footage)), size,
           &theme](std::int64_t frame) {
            return paintedWorld(*environment, *footage, static_cast<std::size_t>(frame), size, theme);
          }};
}

}  // namespace surefoot
