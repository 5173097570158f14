// SPDX-License-Identifier: GPL-3.0-or-later
// The basic types that pass between an environment and an agent in one step.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace surefoot {

/// An action by its index, 0 … actions − 1. The environment knows what it means (a torque, a move).
using Action = int;
inline constexpr Action kNoAction = -1;
/// The environment's own, hand-made controller acts in this step; only for tasks with Task::handMade.
inline constexpr Action kHandMade = -2;

/// Most actions an environment may have, most state variables and most reward terms: those of its task, and two that
/// an agent may add (shaping, the price of a fall). Buffers of these sizes live on the stack.
inline constexpr int kMaxActions = 4096;
inline constexpr int kMaxStateVariables = 32;
inline constexpr int kMaxTaskTerms = 8, kMaxRewardTerms = kMaxTaskTerms + 2;
/// Most measures of an episode (Task::measures).
inline constexpr std::size_t kMaxMeasures = 4;
/// The measures of an episode besides its reward and its falls; unused places are 0.
using EpisodeMeasures = std::array<double, kMaxMeasures>;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How an episode ends. After Terminal the value of the next state is 0; after Truncated (a time limit) it is
/// estimated, because the task would have gone on (Sutton & Barto 2018, section 3.3; Pardo et al. 2018). Unanswered is
/// none: the world did not answer, the step did not happen and can be tried again.
enum class Ending : std::uint8_t { None, Terminal, Truncated, Unanswered };

/// What happened in a step, in a person's words. A fall need not end the episode (the cliff sends the walker back).
enum class Event : std::uint8_t { None, Success, Fall };

/// The answer of an environment to one action. `terms` are the named rewards of Task::rewardTerms in their order;
/// `reward` is their sum.
struct Outcome {
  double reward = 0.0;
  Ending ending = Ending::None;
  Event event = Event::None;
  std::array<double, kMaxRewardTerms> terms{};
};

/// Which estimate to look at: the whole q̂, one of the two parts that Sarsa_2Q keeps (thesis, section 6.1.2), or the
/// risk of a fall.
enum class Layer : std::uint8_t { Sum, Positive, Negative, Risk };

}  // namespace surefoot
