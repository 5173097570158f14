// SPDX-License-Identifier: GPL-3.0-or-later
// One fall of a life, so that it can be looked at again.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/life/episode_inputs.h"

namespace surefoot {

struct Fall {
  std::uint64_t life = 0;      ///< counts the lives that were put into the window
  std::int64_t number = 0;     ///< of the life, from 1
  std::int64_t episode = 0;    ///< from 1
  std::int64_t lifeSteps = 0;  ///< of the life up to it
  std::string policy;
  EpisodeInputs inputs;
  /// The environment's parameters as they held.
  std::shared_ptr<const std::vector<std::pair<std::string, double>>> parameters;

  /// In its episode the body was placed or pushed by a person: it says little of the policy.
  bool byHand() const { return !inputs.start.empty() || !inputs.pushSteps.empty(); }
};

/// As many as a window keeps: the newest, and of those before them a choice that is spread over the life.
inline constexpr std::size_t kMostFalls = 4000, kNewestFalls = 1000;

/// Makes room where there are more than kMostFalls, in the order of the life: of the older ones those go that stand
/// nearest to the one before, so that wherever a curve of the life shows a fall there is one to look at again.
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
