// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <benchmark/benchmark.h>

#include "core/experiment/configuration.h"

namespace surefoot {

/// One life after the other, a batch of steps an iteration; the counter is steps per CPU-second.
inline void live(benchmark::State& state, const Registry& registry, const Names& names,
                 const std::vector<Assignment>& assignments) {
  constexpr std::int64_t kBatch = 10'000, kLong = 1'000'000;
  auto c = configure(registry, names, assignments);
  if (!c) return state.SkipWithError(c.error().message.c_str());
  auto life = makeLife(registry, *c, 0, false);
  if (!life) return state.SkipWithError(life.error().message.c_str());
  for (int i = 0; i < 20; ++i) (*life)->step();
  for (auto _ : state) {
    if ((*life)->steps() > kLong) {
      state.PauseTiming();
      ++c->seed;
      life = makeLife(registry, *c, 0, false);
      state.ResumeTiming();
    }
    for (std::int64_t i = 0; i < kBatch; ++i) (*life)->step();
  }
  state.counters["steps/s"] =
      benchmark::Counter(static_cast<double>(state.iterations() * kBatch), benchmark::Counter::kIsRate);
}

}  // namespace surefoot
