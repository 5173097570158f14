// SPDX-License-Identifier: GPL-3.0-or-later
// The film of a roll-out: prepared before anything is lived, made afterwards.
#pragma once

#include "app/reports/film.h"
#include "app/requests/command_line.h"
#include "core/signals/rollout.h"

namespace surefoot {

class RolloutFilm {
 public:
  /// Checks what is asked for and claims the file; `settings` look at the environment for it from now on. nullptr: no
  /// film is asked for.
  static Result<std::unique_ptr<RolloutFilm>> prepare(const RolloutRequest& request, const Environment& environment,
                                                      bool hasRisk, RolloutSettings& settings);
  /// After the roll-out; with a line of progress on a terminal.
  Status make(const Rollout& rollout);

 private:
  RolloutFilm(FilmMaker maker, const Environment& environment);

  FilmMaker maker_;
  const Environment& environment_;
  double step_;  // [s] in the film
  FootageTaker taker_;
};

}  // namespace surefoot
