// SPDX-License-Identifier: GPL-3.0-or-later
// What a policy does, step by step: an environment is lived in by a Q-function that learns nothing, and every signal is
// written down. Nothing here is part of the learning loop.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/life/episode_inputs.h"
#include "core/policy.h"
#include "core/signals/signal_table.h"
#include "core/values_of_state.h"

namespace surefoot {

/// A push at a time after the beginning.
struct TimedPush {
  double time = 0.0;     ///< [s]
  double impulse = 0.0;  ///< [N s]
};

/// What can be seen of a moment that is lived: one before an action, or the state in which an episode ended.
struct RolloutMoment {
  const Environment& environment;
  const ValuesOfState& here;  ///< what the Q-function says of it
  double time = 0.0;          ///< [s], or steps without a clock
  std::int64_t row = 0;       ///< its row in the table; of an end after which nothing is written down, the one before
  Action next = kNoAction;    ///< the action that comes next; kNoAction: the episode is over
  bool fell = false;          ///< it ended with a fall
};
using SeeMoment = std::function<void(const RolloutMoment&)>;

struct RolloutSettings {
  std::uint64_t seed = 1;       ///< of starts, and of a policy that draws
  std::vector<double> start{};  ///< the state of the first episode; empty: the environment draws one
  std::int64_t steps = 0;       ///< at most; episodes follow each other until then
  std::optional<std::int64_t> episodes{};
  double discount = 1.0;            ///< γ, for δ
  std::vector<TimedPush> pushes{};  ///< in the order of their times
  /// The first episode begins as this one did: its random numbers, its start, its pushes. nullptr: as said above.
  const EpisodeInputs* as = nullptr;
  SeeMoment see{};  ///< looking changes nothing
};

struct Rollout {
  SignalTable table;
  std::int64_t steps = 0, episodes = 0, falls = 0, successes = 0;
  double reward = 0.0;
  std::vector<double> measures;  ///< Task::measures over all episodes, as a life has them
  std::string stopped{};         ///< why the environment did not go on; empty: it did
};

/// Used by one thread. `interrupted`: ends where it is.
Rollout rollOut(Environment& environment, const ActionValueFunction& values, const Policy& policy,
                const RolloutSettings& settings, const std::atomic<bool>* interrupted = nullptr);

/// An episode lived again with the actions of then, and what a Q-function (nullptr: none) and a policy say of them now;
/// its last row is the state that it ended in. No rows: the episode cannot be repeated.
SignalTable relive(Environment& environment, const EpisodeInputs& inputs, const ActionValueFunction* values,
                   const Policy& policy, double discount, const SeeMoment& see = {});

}  // namespace surefoot
