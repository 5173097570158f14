// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/meter.h"

#include <time.h>

#include <algorithm>

namespace surefoot {

void Meter::update(const Life& life) {
  const auto part = [](std::int64_t reached, std::int64_t limit) {
    return static_cast<double>(reached) / static_cast<double>(limit);
  };
  steps.store(life.steps(), std::memory_order_relaxed);
  falls.store(life.log().totals().falls, std::memory_order_relaxed);
  share.store(std::min(1.0, std::max(part(life.steps(), life.limits().steps),
                                     part(life.log().totals().episodes, life.limits().episodes))),
              std::memory_order_relaxed);
}

Progress sum(const std::vector<Meter>& meters) {
  Progress p;
  for (const Meter& meter : meters) {
    const bool done = meter.done.load(std::memory_order_relaxed);
    p.steps += meter.steps.load(std::memory_order_relaxed);
    p.falls += meter.falls.load(std::memory_order_relaxed);
    p.share += (done ? 1.0 : meter.share.load(std::memory_order_relaxed)) / static_cast<double>(meters.size());
    p.livesDone += done;
  }
  return p;
}

void live(Life& life, std::int64_t steps, const WorkPool& pool, Meter& meter) {
  const std::int64_t most = life.environment().answersAtOnce() ? 256 : 1;  // steps; a life can stop only after them
  while (!life.finished() && life.steps() < steps && !pool.stopping() && !pool.paused()) {
    const std::int64_t batch = std::min(most, steps - life.steps());
    for (std::int64_t i = 0; i < batch && !life.finished(); ++i) life.step(pool.interrupted());
    meter.update(life);
  }
}

}  // namespace surefoot
