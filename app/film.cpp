// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "app/headless_qt.h"
#include "app/reports/film.h"
#include "core/text/text.h"
#include "ui/film/film_writer.h"
#include "ui/film/world_film.h"

namespace surefoot {

struct FilmMaker::Claimed {
  FilmKind kind;
  QSize size;
  const Theme& theme;
  WholeFile file;
};

FilmMaker::FilmMaker(std::unique_ptr<Claimed> claimed) : claimed_(std::move(claimed)) {}
FilmMaker::FilmMaker(FilmMaker&&) noexcept = default;
FilmMaker::~FilmMaker() = default;

Result<FilmMaker> FilmMaker::claim(const FilmOptions& options, std::int64_t frames) {
  QSize size = kUsualFilmSize;
  if (options.size) {
    const auto parsed = parseFilmSize("--size", *options.size);
    if (!parsed) return parsed.error();
    size = *parsed;
  }
  const std::string appearance = options.appearance.value_or("light");
  if (appearance != "light" && appearance != "dark")
    return Error{fmt::format("--appearance: \"{}\" is none; it is light or dark.", shortened(appearance))};
  auto kind = checkFilm("--film", options.path, size, frames);
  if (!kind) return kind.error();
  auto file = WholeFile::createNew("--film", options.path);
  if (!file) return file.error();
  return FilmMaker(std::make_unique<Claimed>(
      Claimed{std::move(*kind), size, appearance == "dark" ? darkTheme() : lightTheme(), std::move(*file)}));
}

Status FilmMaker::make(std::shared_ptr<const Environment> environment, Footage footage,
                       const std::atomic<bool>& interrupted, const std::function<void(std::int64_t frames)>& done) {
  const HeadlessQt qt;
  const Film film = worldFilm(std::move(environment), std::move(footage), claimed_->size, claimed_->theme);
  return writeFilm("--film", film, claimed_->kind, std::move(claimed_->file), interrupted, done);
}

}  // namespace surefoot
