// SPDX-License-Identifier: GPL-3.0-or-later
// Paints a film and encodes it into a file, which appears whole or not at all.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "core/files/whole_file.h"
#include "ui/film/film.h"
#include "ui/film/film_kind.h"

namespace surefoot {

/// `file` was claimed before anything was computed; `name` names the film in messages. Any thread; `done` is called
/// with the number of pictures so far. The same film gives the same bytes.
Status writeFilm(const std::string& name, const Film& film, const FilmKind& kind, WholeFile file,
                 const std::atomic<bool>& interrupted, const std::function<void(std::int64_t frames)>& done = {});

/// Of the library that encodes WebP.
std::string webpVersion();

}  // namespace surefoot
