// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/rollout_film.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "app/process/interrupt.h"
#include "app/reports/progress_line.h"

namespace surefoot {

RolloutFilm::RolloutFilm(FilmMaker maker, const Environment& environment)
    : maker_(std::move(maker)),
      environment_(environment),
      step_(environment.task().stepTime.value_or(kUnclockedStep)) {}

Result<std::unique_ptr<RolloutFilm>> RolloutFilm::prepare(const RolloutRequest& r, const Environment& environment,
                                                          bool hasRisk, RolloutSettings& settings) {
  if (!r.film) {
    for (const auto& [option, value] :
         {std::pair{"--size", &r.size}, {"--appearance", &r.appearance}, {"--strips", &r.strips}})
      if (*value) return Error{fmt::format("{}: it says how a film looks; give --film, too.", option)};
    return std::unique_ptr<RolloutFilm>();
  }
  if (settings.steps == 0) return Error{"--film: in so short a time there is no step to be seen."};
  const std::optional<double> clock = environment.task().stepTime;
  const double step = clock.value_or(kUnclockedStep);
  const bool known = r.seconds || !settings.episodes;  // how long it takes; else the episodes decide
  auto maker = FilmMaker::claim({*r.film, r.size, r.appearance, r.strips},
                                known ? filmFrames(static_cast<double>(settings.steps) * step) : 1,
                                signalsOf(environment, hasRisk));
  if (!maker) return maker.error();
  const double longest = static_cast<double>(kMostFilmFrames) / kFilmRate;
  if (!known) settings.steps = std::min<std::int64_t>(settings.steps, std::llround(longest / step) + 1);
  std::unique_ptr<RolloutFilm> film(new RolloutFilm(std::move(*maker), environment));
  settings.see = [&taker = film->taker_, unit = clock ? 1.0 : step](const RolloutMoment& m) {
    taker.look(m.environment, m.time * unit, m.fell, m.row);
  };
  return film;
}

Status RolloutFilm::make(const Rollout& rollout) {
  const double seconds = static_cast<double>(rollout.steps) * step_;
  if (filmFrames(seconds) > kMostFilmFrames)
    return Error{fmt::format("--film: the episodes last longer than the {:.0f} s that a film may have; take fewer.",
                             static_cast<double>(kMostFilmFrames) / kFilmRate)};
  Footage footage = taker_.finish(seconds);
  const auto frames = static_cast<std::int64_t>(footage.poses.size());
  std::optional<ProgressLine> line;
  if (isatty(STDERR_FILENO)) line.emplace();
  const std::shared_ptr<const Environment> painted(std::shared_ptr<void>(), &environment_);  // it is not ours to end
  return maker_.make(painted, std::move(footage), rollout.table, watchForInterrupt(), [&](std::int64_t done) {
    if (line && (done % 8 == 0 || done == frames))
      line->show(static_cast<double>(done) / static_cast<double>(frames),
                 fmt::format("film: {} of {} pictures", done, frames));
  });
}

}  // namespace surefoot
