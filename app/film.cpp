// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "app/headless_qt.h"
#include "app/reports/film.h"
#include "core/text/text.h"
#include "ui/film/film_writer.h"
#include "ui/live/signals/strip_film.h"

namespace surefoot {

struct FilmMaker::Claimed {
  FilmKind kind;
  QSize size;
  const Theme& theme;
  std::vector<Strip> strips;
  WholeFile file;
};

FilmMaker::FilmMaker(std::unique_ptr<Claimed> claimed) : claimed_(std::move(claimed)) {}
FilmMaker::FilmMaker(FilmMaker&&) noexcept = default;
FilmMaker::~FilmMaker() = default;

namespace {

Result<std::vector<Strip>> stripsOf(const std::optional<std::string>& text, const std::vector<Signal>& signals) {
  std::vector<Strip> strips;
  if (!text) return strips;
  if (*text == "usual") return usualStrips(signals);
  strips = fromSettings(QString::fromStdString(*text));
  if (strips.empty()) return Error{"--strips: keys of signals are expected, such as pole_angle,reward; or usual."};
  for (const Strip& strip : strips)
    for (const std::string& key : strip)
      if (signalAt(signals, key) == signals.size())
        return Error{
            fmt::format("--strips: there is no signal {}; surefoot rollout --json lists their keys.", shortened(key))};
  return strips;
}

}  // namespace

Result<FilmMaker> FilmMaker::claim(const FilmOptions& options, std::int64_t frames,
                                   const std::vector<Signal>& signals) {
  QSize size = kUsualFilmSize;
  if (options.size) {
    const auto parsed = parseFilmSize("--size", *options.size);
    if (!parsed) return parsed.error();
    size = *parsed;
  }
  const std::string appearance = options.appearance.value_or("light");
  if (appearance != "light" && appearance != "dark")
    return Error{fmt::format("--appearance: \"{}\" is none; it is light or dark.", shortened(appearance))};
  auto strips = stripsOf(options.strips, signals);
  if (!strips) return strips.error();
  auto kind = checkFilm("--film", options.path, size, frames);
  if (!kind) return kind.error();
  auto file = WholeFile::createNew("--film", options.path);
  if (!file) return file.error();
  return FilmMaker(
      std::make_unique<Claimed>(Claimed{std::move(*kind), size, appearance == "dark" ? darkTheme() : lightTheme(),
                                        std::move(*strips), std::move(*file)}));
}

Status FilmMaker::make(std::shared_ptr<const Environment> environment, Footage footage, const SignalTable& table,
                       const std::atomic<bool>& interrupted, const std::function<void(std::int64_t frames)>& done) {
  const HeadlessQt qt;
  const std::shared_ptr<const SignalTable> shown(std::shared_ptr<void>(), &table);  // it is not ours to end
  const Film film =
      filmOf(std::move(environment), std::move(footage), {shown, claimed_->strips}, claimed_->size, claimed_->theme);
  return writeFilm("--film", film, claimed_->kind, std::move(claimed_->file), interrupted, done);
}

}  // namespace surefoot
