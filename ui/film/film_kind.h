// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of films, by the endings of their files, and what is checked before one is made.
#pragma once

#include <QSize>
#include <span>
#include <string>
#include <vector>

#include "core/basics/result.h"

namespace surefoot {

struct FilmKind {
  std::string ending;  ///< ".webp"
  std::string title;   ///< "Animated WebP"
  bool even = false;   ///< width and height must be even
  /// For the program ffmpeg: how it encodes. Empty: it is not needed.
  std::vector<std::string> arguments{};

  bool byFfmpeg() const { return !arguments.empty(); }
};

/// All of them; those that need nothing else come first.
std::span<const FilmKind> filmKinds();

/// Width and height of a film [px].
inline constexpr int kLeastFilmSide = 64, kMostFilmSide = 3840;
inline constexpr QSize kUsualFilmSize(960, 540);

/// "960x540"
Result<QSize> parseFilmSize(const std::string& name, const std::string& text);

/// Whether a film of this size and length can be written under this name, here and now. `name` names the film in
/// messages: "--film".
Result<FilmKind> checkFilm(const std::string& name, const std::string& path, QSize size, std::int64_t frames);

/// The path of the program ffmpeg; empty: it is not installed.
std::string ffmpegProgram();

}  // namespace surefoot
