// SPDX-License-Identifier: GPL-3.0-or-later
// One fall of a life, so that it can be looked at again.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/experiment/episode_inputs.h"

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
};

/// As many as a window keeps; the oldest go first.
inline constexpr std::size_t kMostFalls = 1000;

}  // namespace surefoot
