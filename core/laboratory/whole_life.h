// SPDX-License-Identifier: GPL-3.0-or-later
// Lives a life of a plan from its present state to its end, on a thread of a pool. It is kept on the way, so that it
// can be continued later.
#pragma once

#include <chrono>
#include <functional>

#include "core/experiment/meter.h"
#include "core/saved/checkpoint.h"

namespace surefoot {

/// Returns when the life is finished or the pool stops; while the pool is paused the life stands still. `keep` is
/// called between two steps: when the life stops before its end, some seconds into a pause, and about once in every
/// `every` (less often where keeping takes long).
void liveWhole(Life& life, Meter& meter, const WorkPool& pool, std::chrono::duration<double> every,
               const std::function<void()>& keep);

/// A life that was kept; nullptr: there is none, or it does not fit.
std::unique_ptr<Life> takeUp(const Registry& registry, std::shared_ptr<const TensorFile> file, bool keepRows);

}  // namespace surefoot
