// SPDX-License-Identifier: GPL-3.0-or-later
// One fall of a life, recorded so that it can be shown again.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/life/episode_inputs.h"

namespace surefoot {

struct Fall {
  std::uint64_t life = 0;      ///< counts the lives that were put into the window
  std::int64_t number = 0;     ///< number of the fall in its life, from 1
  std::int64_t episode = 0;    ///< from 1
  std::int64_t lifeSteps = 0;  ///< steps of the life up to the fall
  std::string policy;
  EpisodeInputs inputs;
  /// The environment's parameters in that episode.
  std::shared_ptr<const std::vector<std::pair<std::string, double>>> parameters;

  /// A person placed or pushed the body in this episode, or went on with an earlier one: the fall says little about the
  /// policy.
  bool byHand() const { return !inputs.start.empty() || !inputs.pushSteps.empty() || inputs.before > 0; }
};

/// A window keeps at most this many falls: the newest, and a selection of older ones spread over the life.
inline constexpr std::size_t kMostFalls = 4000, kNewestFalls = 1000;

/// Removes falls if there are more than kMostFalls (in the order of the life). Older falls that are nearest to the fall
/// before them go first: so wherever a curve of the life shows a fall, there is one to show again.
template <class Falls>
void thinOut(Falls& falls) {
  if (falls.size() <= kMostFalls) return;
  for (std::int64_t resolution = 2048; resolution > 0 && falls.size() > kMostFalls * 3 / 4; resolution /= 2) {
    const std::size_t older = falls.size() - kNewestFalls;
    std::size_t kept = 1;
    for (std::size_t i = 1; i < falls.size(); ++i) {
      const Fall &fall = falls[i], &before = falls[kept - 1];
      const bool near = (fall.lifeSteps - before.lifeSteps) * resolution < fall.lifeSteps &&
                        (fall.episode - before.episode) * resolution < fall.episode;
      if (near && i < older) continue;
      if (kept != i) falls[kept] = std::move(falls[i]);
      ++kept;
    }
    falls.resize(kept);
  }
}

}  // namespace surefoot
