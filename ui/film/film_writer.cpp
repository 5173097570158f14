// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/film_writer.h"

#include "ui/film/film_encoder.h"

namespace surefoot {

Status writeFilm(const std::string& name, const Film& film, const FilmKind& kind, WholeFile file,
                 const std::atomic<bool>& interrupted, const std::function<void(std::int64_t frames)>& done) {
  const Error stopped{name + ": interrupted; nothing is written.", ErrorKind::Interrupted};
  const FilmJob job{name, kind, film.size, interrupted};
  auto encoder = kind.byFfmpeg() ? makeFfmpegEncoder(job, file) : makeWebpEncoder(job);
  if (!encoder) return encoder.error();
  for (std::int64_t i = 0; i < film.frames; ++i) {
    const Status added = (*encoder)->add(film.picture(i));
    if (interrupted) return stopped;
    if (!added) return added.error();
    if (done) done(i + 1);
  }
  const Status finished = (*encoder)->finish(file);
  if (interrupted) return stopped;
  if (!finished) return finished.error();
  return file.commit();
}

}  // namespace surefoot
