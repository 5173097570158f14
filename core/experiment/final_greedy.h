// SPDX-License-Identifier: GPL-3.0-or-later
// What a life has learned, apart from how it explores: the greedy policy on the learned values, which stay as they are.
#pragma once

#include <optional>

#include "core/experiment/configuration.h"
#include "core/life/life.h"

namespace surefoot {

/// Per episode.
struct FinalGreedy {
  double falls = 0.0, reward = 0.0;
  int episodes = 0;
};

/// Greedy episodes in an environment as it is at the life's end (`configuration` names it), up to kMostEpisodes, but no
/// more steps than kMostShare of the life's (kLeastEpisodes are always made). All lives begin them in the same states.
/// An error: the environment cannot be made.
Result<FinalGreedy> finalGreedy(const Registry& registry, Configuration configuration, const Life& life);

inline constexpr int kMostEpisodes = 100, kLeastEpisodes = 10;
inline constexpr double kMostShare = 0.1;

}  // namespace surefoot
