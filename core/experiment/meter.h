// SPDX-License-Identifier: GPL-3.0-or-later
// How far lives on other threads are.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/experiment/work_pool.h"
#include "core/life/life.h"

namespace surefoot {

struct Progress {
  std::int64_t steps = 0;  ///< steps of all lives
  std::int64_t falls = 0;
  int livesDone = 0;
  double share = 0.0;  ///< share of the whole work, 0 … 1
};

/// The progress of one life, on a cache line of its own: its thread writes, another reads now and then.
struct alignas(64) Meter {
  std::atomic<std::int64_t> steps{0}, falls{0};
  std::atomic<double> share{0.0};
  std::atomic<bool> done{false};

  void update(const Life& life);
};

Progress sum(const std::vector<Meter>& meters);

/// A number of steps that no life takes.
inline constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

/// Steps a life until it has taken `steps`, is finished, or the pool stops or is paused.
void live(Life& life, std::int64_t steps, const WorkPool& pool, Meter& meter);

}  // namespace surefoot
