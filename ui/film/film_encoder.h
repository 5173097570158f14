// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a file of pictures. Used by one thread.
#pragma once

#include <QImage>
#include <atomic>
#include <memory>
#include <string>

#include "core/files/whole_file.h"
#include "ui/film/film_kind.h"

namespace surefoot {

class FilmEncoder {
 public:
  virtual ~FilmEncoder() = default;
  /// The next picture; all are of one size and opaque.
  virtual Status add(const QImage& picture) = 0;
  /// Encodes the rest and writes everything into the file, which is not yet given its name.
  virtual Status finish(WholeFile& file) = 0;
};

/// What encoders are told. `name` names the film in messages.
struct FilmJob {
  std::string name;
  FilmKind kind;
  QSize size;
  const std::atomic<bool>& interrupted;  ///< waiting ends when this is set
};

/// Every picture to the last bit, only what has changed since the one before; equal pictures become one that stays.
Result<std::unique_ptr<FilmEncoder>> makeWebpEncoder(const FilmJob& job);

/// The program ffmpeg, as a process of its own, which writes into `file` by itself.
Result<std::unique_ptr<FilmEncoder>> makeFfmpegEncoder(const FilmJob& job, const WholeFile& file);

}  // namespace surefoot
