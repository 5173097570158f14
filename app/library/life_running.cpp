// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <cmath>
#include <limits>

#include "app/library/description.h"
#include "app/library/life_handle.h"
#include "app/library/outcomes.h"
#include "app/reports/report.h"
#include "core/basics/cpu_time.h"
#include "core/basics/typed_json.h"
#include "core/experiment/experiment.h"

using namespace surefoot;

namespace {

constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

/// How far a life goes, in its own counts.
struct Limits {
  std::int64_t steps = kMost, episodes = kMost;
  bool reachedBy(const Life& life) const { return life.steps() >= steps || life.log().totals().episodes >= episodes; }
};

Result<Limits> limitsOf(const surefoot_extent& extent, const Task& task) {
  constexpr double kMostMinutes = 1e9;
  if (extent.steps < 0 || extent.episodes < 0 || !(extent.minutes >= 0 && extent.minutes <= kMostMinutes) ||
      !(extent.patience >= 0))
    return Error{fmt::format("extent: no limit may be negative or no number, and minutes go up to {}.", kMostMinutes)};
  if (extent.steps == 0 && extent.episodes == 0 && extent.minutes == 0 && extent.patience == 0)
    return Error{"extent: a limit is needed: steps, episodes, minutes or patience."};
  Limits limits;
  if (extent.steps > 0) limits.steps = extent.steps;
  if (extent.episodes > 0) limits.episodes = extent.episodes;
  if (extent.minutes == 0) return limits;
  if (!task.stepTime) return Error{"minutes: this task has no clock; give steps or episodes instead."};
  limits.steps = std::min<std::int64_t>(limits.steps, std::llround(extent.minutes * 60.0 / *task.stepTime));
  return limits;
}

/// Steps on until a limit of these, the life's end, or the end of patience [s]; 0: patience has none.
void run(surefoot_life& l, const Limits& limits, double patience) {
  using Clock = std::chrono::steady_clock;
  Life& life = *l.life;
  const auto begun = Clock::now();
  const std::int64_t between = life.environment().answersAtOnce() ? 256 : 1;  // steps between two looks at the clock
  const bool watched = limits.episodes != kMost || l.hasOwnPolicy;            // after every step
  const auto over = [&] { return life.finished() || limits.reachedBy(life) || l.mishap->ofPolicy; };
  const auto patient = [&] {
    return patience == 0 || std::chrono::duration<double>(Clock::now() - begun).count() < patience;
  };
  if (!life.unanswered().empty()) life.step();  // tries again what was not answered
  life.begin();
  while (!over()) {
    const std::int64_t batch = std::min(between, limits.steps - life.steps());
    for (std::int64_t i = 0; i < batch && !life.finished(); ++i) {
      life.step();
      if (watched && over()) return;
    }
    if (!patient()) return;
  }
}

}  // namespace

surefoot_status surefoot_life_run(surefoot_life* life, const surefoot_extent* extent, int32_t* reached) {
  return withLife(life, [&](surefoot_life& l) -> Status {
    if (!extent || !reached) return Error{"extent and reached must not be NULL."};
    const auto limits = limitsOf(*extent, l.task());
    if (!limits) return limits.error();
    const double before = threadCpuSeconds();
    l.mishap->ofPolicy = false;
    if (!l.life->diverged() && !limits->reachedBy(*l.life)) run(l, *limits, extent->patience);
    l.cpuSeconds += threadCpuSeconds() - before;
    if (l.life->diverged()) return Error{l.life->divergence(), ErrorKind::Diverged};
    if (l.mishap->ofPolicy)
      return Error{"The caller's policy gave no probabilities; this step was taken as if all were equal.",
                   ErrorKind::Unanswered};
    if (!l.life->unanswered().empty()) return Error{l.life->unanswered(), ErrorKind::Unanswered};
    *reached = limits->reachedBy(*l.life) || l.life->finished();
    return Done{};
  });
}

surefoot_status surefoot_life_totals(surefoot_life* life, surefoot_totals* totals) {
  return withLife(life, [&](surefoot_life& l) -> Status {
    if (!totals) return Error{"totals: it is NULL."};
    const LifeTotals& t = l.life->log().totals();
    const std::int64_t steps = l.life->steps();
    *totals = {
        .steps = steps,
        .episodes = t.episodes,
        .falls = t.falls,
        .successes = t.successes,
        .simulated_seconds = l.life->simulatedSeconds(),
        .average_reward = t.episodes > 0 ? l.life->log().averageReward() : 0.0,
        .exploring = steps > 0 ? static_cast<double>(l.life->agent().explored()) / static_cast<double>(steps) : 0,
        .states_outside = l.life->agent().statesOutside()};
    return Done{};
  });
}

surefoot_status surefoot_life_hash(surefoot_life* life, uint64_t* hash) {
  return withLife(life, [&](surefoot_life& l) -> Status {
    if (!hash) return Error{"hash: it is NULL."};
    *hash = l.life->hash();
    return Done{};
  });
}

surefoot_status surefoot_life_about(surefoot_life* life, const char** json) {
  return withLife(life, [&](surefoot_life& l) {
    std::string text = resultAsJson(l.configuration, {summarise(*l.life, l.index, l.cpuSeconds)});
    return handOut(l, std::move(text), json);
  });
}

surefoot_status surefoot_life_task(surefoot_life* life, const char** json) {
  return withLife(life, [&](surefoot_life& l) {
    return handOut(l, jsonText(aboutWorld(l.life->environment(), l.configuration)), json);
  });
}
