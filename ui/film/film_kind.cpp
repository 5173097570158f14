// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/film_kind.h"

#include <fmt/format.h>

#include <QStandardPaths>
#include <algorithm>
#include <filesystem>

#include "core/signals/footage.h"
#include "core/text/number_text.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

namespace {

/// Endings, of all kinds or of those that need no other program.
std::string endings(bool withoutFfmpeg) {
  std::vector<std::string> names;
  for (const FilmKind& kind : filmKinds())
    if (!withoutFfmpeg || !kind.byFfmpeg()) names.push_back(kind.ending);
  return joinWords(names, "or");
}

Status checkSides(const std::string& name, QSize size) {
  for (const int side : {size.width(), size.height()})
    if (side < kLeastFilmSide || side > kMostFilmSide)
      return Error{fmt::format("{}: {}x{} is no size of a film; width and height are {} to {} pixels each.", name,
                               size.width(), size.height(), kLeastFilmSide, kMostFilmSide)};
  return Done{};
}

}  // namespace

// A GIF has 256 colours: each picture has its own.
std::span<const FilmKind> filmKinds() {
  static const std::vector<FilmKind> kinds = {
      {.ending = ".webp", .title = QT_TRANSLATE_NOOP("core", "Animated WebP")},
      {.ending = ".gif",
       .title = QT_TRANSLATE_NOOP("core", "Animated GIF"),
       .arguments = {"-filter_complex",
                     "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=none", "-f", "gif"}},
      {.ending = ".apng",
       .title = QT_TRANSLATE_NOOP("core", "Animated PNG"),
       .arguments = {"-c:v", "apng", "-plays", "0", "-pred", "mixed", "-f", "apng"}},
      {.ending = ".mp4",
       .title = QT_TRANSLATE_NOOP("core", "MP4 video"),
       .even = true,
       .arguments = {"-c:v", "libx264", "-preset", "medium", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags",
                     "+faststart", "-f", "mp4"}},
      {.ending = ".webm",
       .title = QT_TRANSLATE_NOOP("core", "WebM video"),
       .arguments = {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-deadline", "good", "-cpu-used", "4", "-row-mt",
                     "1", "-pix_fmt", "yuv420p", "-f", "webm"}}};
  return kinds;
}

Result<QSize> parseFilmSize(const std::string& name, const std::string& text) {
  const auto cross = text.find('x');
  const auto side = [&](const std::string& digits) {
    const auto number = parseWhole(name, digits, 0, 1'000'000'000);
    return number ? static_cast<int>(*number) : -1;
  };
  const int width = cross == std::string::npos ? -1 : side(text.substr(0, cross));
  const int height = cross == std::string::npos ? -1 : side(text.substr(cross + 1));
  if (width < 0 || height < 0)
    return Error{fmt::format("{}: \"{}\" is no size of a film; WIDTHxHEIGHT in pixels is needed, such as 960x540.",
                             name, shortened(text))};
  if (const Status s = checkSides(name, {width, height}); !s) return s.error();
  return QSize(width, height);
}

Result<FilmKind> checkFilm(const std::string& name, const std::string& path, QSize size, std::int64_t frames) {
  const std::string ending = std::filesystem::path(path).extension().string();
  const auto kinds = filmKinds();
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const FilmKind& k) { return k.ending == ending; });
  if (kind == kinds.end())
    return Error{
        fmt::format("{}: the ending of {} says no kind of film; it takes {}.", name, shortened(path), endings(false))};
  if (const Status s = checkSides(name, size); !s) return s.error();
  if (kind->even && (size.width() % 2 != 0 || size.height() % 2 != 0))
    return Error{fmt::format("{}: a film {} has an even width and height, not {}x{}.", name, ending, size.width(),
                             size.height())};
  if (frames > kMostFilmFrames)
    return Error{fmt::format("{}: a film has at most {} pictures ({:.0f} s), not {}.", name,
                             countText(static_cast<double>(kMostFilmFrames)), kMostFilmFrames / kFilmRate,
                             countText(static_cast<double>(frames)))};
  if (kind->byFfmpeg() && ffmpegProgram().empty())
    return Error{fmt::format("{}: {} is made by the program ffmpeg, which is not installed (apt-get install ffmpeg); "
                             "{} needs none.",
                             name, ending, endings(true)),
                 ErrorKind::File};
  return *kind;
}

std::string ffmpegProgram() {
  return QStandardPaths::findExecutable(QStringLiteral("ffmpeg")).toStdString();
}

}  // namespace surefoot
