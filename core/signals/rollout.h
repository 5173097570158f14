// SPDX-License-Identifier: GPL-3.0-or-later
// What a policy does, step by step: an environment is lived in by a Q-function that learns nothing, and every signal is
// written down. Nothing here is part of the learning loop.
//
// A row is the moment before an action: the time, the state and the environment's signals then, the action that was
// chosen and what the Q-function said of it, and the reward that it brought. Numbers that a row does not have are NaN:
// δ in the last row of an episode that was cut off by the end of the roll-out.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/action_value.h"
#include "core/environment.h"
#include "core/policy.h"

namespace surefoot {

/// A push at a time after the beginning.
struct TimedPush {
  double time = 0.0;     ///< [s]
  double impulse = 0.0;  ///< [N s]
};

struct RolloutSettings {
  std::uint64_t seed = 1;       ///< of starts, and of a policy that draws
  std::vector<double> start{};  ///< the state of the first episode; empty: the environment draws one
  std::int64_t steps = 0;       ///< at most; episodes follow each other until then
  std::optional<std::int64_t> episodes{};
  double discount = 1.0;            ///< γ, for δ
  std::vector<TimedPush> pushes{};  ///< in the order of their times
};

/// Columns of numbers, one row a step.
struct Rollout {
  std::vector<Signal> signals;               ///< the columns
  std::vector<std::vector<double>> columns;  ///< [signal][row]
  std::int64_t steps = 0, episodes = 0, falls = 0, successes = 0;
  double reward = 0.0;
  std::vector<double> measures;  ///< Task::measures over all episodes, as a life has them
  std::string stopped{};         ///< why the environment did not go on; empty: it did

  const std::vector<double>* column(std::string_view key) const;
};

/// Every signal of a roll-out: time and episode, the state, the environment's own, the action, the learner's, the
/// reward and its terms.
std::vector<Signal> signalsOf(const Environment& environment, const ActionValueFunction& values);

/// Used by one thread. `interrupted`: ends where it is.
Rollout rollOut(Environment& environment, const ActionValueFunction& values, const Policy& policy,
                const RolloutSettings& settings, const std::atomic<bool>* interrupted = nullptr);

}  // namespace surefoot
