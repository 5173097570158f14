// SPDX-License-Identifier: GPL-3.0-or-later
// In place of film.cpp where the program is built without Qt.
#include "app/reports/film.h"

namespace surefoot {

struct FilmMaker::Claimed {};
FilmMaker::FilmMaker(std::unique_ptr<Claimed> claimed) : claimed_(std::move(claimed)) {}
FilmMaker::FilmMaker(FilmMaker&&) noexcept = default;
FilmMaker::~FilmMaker() = default;

Result<FilmMaker> FilmMaker::claim(const FilmOptions&, std::int64_t, const std::vector<Signal>&) {
  return Error{"--film: this program was built without its window (SUREFOOT_UI=OFF), which paints films."};
}

Status FilmMaker::make(std::shared_ptr<const Environment>, Footage, const SignalTable&, const std::atomic<bool>&,
                       const std::function<void(std::int64_t frames)>&) {
  return Done{};
}

}  // namespace surefoot
