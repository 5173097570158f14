// SPDX-License-Identifier: GPL-3.0-or-later
// Two lives lived side by side, to the first step in which they do not do the same.
#pragma once

#include "core/difference/difference.h"
#include "core/life/life.h"

namespace surefoot {

/// Compares after every step, in this order: the action that was taken, the state it led to, the reward of the episode
/// so far, how the episode ended, whether a fall was taken back; after `steps` steps what was learned. None: all of it
/// is the same. An error: an environment did not answer, or `interrupted`.
Result<std::optional<Parting>> partingOf(Life& first, Life& second, std::int64_t steps,
                                         const std::atomic<bool>* interrupted);

}  // namespace surefoot
