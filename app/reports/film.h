// SPDX-License-Identifier: GPL-3.0-or-later
// Films of what a robot did, if the program was built with its window.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/basics/result.h"
#include "core/environment.h"
#include "core/signals/footage.h"
#include "core/signals/signal_table.h"

namespace surefoot {

/// What is asked for, as it was written.
struct FilmOptions {
  std::string path;                       ///< its ending says the kind of film
  std::optional<std::string> size{};      ///< "960x540"
  std::optional<std::string> appearance;  ///< "light" or "dark"
  std::optional<std::string> strips{};    ///< keys of signals to be shown below: "pole_angle,reward_goal+reward_time"
};

class FilmMaker {
 public:
  /// Checks everything that can be checked before anything is lived, and claims the file. `frames`: as many as it will
  /// have, if that is known; `signals`: those that can stand below it.
  static Result<FilmMaker> claim(const FilmOptions& options, std::int64_t frames, const std::vector<Signal>& signals);
  FilmMaker(FilmMaker&&) noexcept;
  ~FilmMaker();

  /// Paints and writes it; no display is needed. `table`: the signals of every step of it. `done` is called with the
  /// number of pictures so far.
  Status make(std::shared_ptr<const Environment> environment, Footage footage, const SignalTable& table,
              const std::atomic<bool>& interrupted, const std::function<void(std::int64_t frames)>& done);

 private:
  struct Claimed;
  explicit FilmMaker(std::unique_ptr<Claimed> claimed);
  std::unique_ptr<Claimed> claimed_;
};

}  // namespace surefoot
