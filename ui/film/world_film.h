// SPDX-License-Identifier: GPL-3.0-or-later
// The world as a film, as the window paints it: with floor, trail and read-outs.
#pragma once

#include <memory>

#include "core/environment.h"
#include "core/signals/footage.h"
#include "ui/film/film.h"

namespace surefoot {

struct Theme;

/// `footage` has kFilmRate poses a second. Texts and lines are as large as in a view of 576 × 400 pixels that is
/// enlarged to `size`, so a film of any size shows the same. `environment` draws poses; it is used by the film alone.
Film worldFilm(std::shared_ptr<const Environment> environment, Footage footage, QSize size, const Theme& theme);

}  // namespace surefoot
