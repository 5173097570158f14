// SPDX-License-Identifier: GPL-3.0-or-later
// One trial of a policy: it lives, is pushed once, and what becomes of it is seen.
//
// A robot is pushed while it does what it does, so a trial begins with the policy's own behaviour. It starts as the
// environment starts, and lives, episode after episode, up to the moment of the push; a robot that falls or reaches its
// goal before is set up again, and counts for nothing. From the push on the episode in hand is followed until its first
// fall, its first success, its end, or until the time is up: whichever comes first is how the trial ended. A push of 0
// tells how often the robot falls in that time by itself.
//
// Start, moment and draws depend on the seed and the trial's number alone, so that trials of one number are pairs
// whatever the push, the model and the Q-function. The push acts as in a roll-out: between the choice of an action and
// the step. A task without a clock has no moment: its trials are whole episodes. Caution is the policy's; a guardian
// does not act. Nothing is learned.
#pragma once

#include <atomic>
#include <cstdint>

#include "core/action_value.h"
#include "core/environment.h"
#include "core/policy.h"

namespace surefoot {

struct Trial {
  std::uint64_t seed = 1;
  std::uint64_t number = 0;
  std::int64_t earliest = 0, latest = 0;  ///< [steps] the moment of the push is drawn uniformly between these
  std::int64_t after = 0;                 ///< [steps] followed from the push on; above 0
  double impulse = 0.0;                   ///< [N s]
};

/// FlewApart: the world came to numbers that are none or beyond all bounds (Environment::cutOffs). Held: none of the
/// others, it still stands.
enum class TrialEnd { Held, Fell, Succeeded, FlewApart };

/// The moment of the push [steps].
std::int64_t momentOf(const Trial& trial);

/// Used by one thread. An error: the environment did not answer. `interrupted`: ends where it is, as Held.
Result<TrialEnd> tryOnce(Environment& environment, const ActionValueFunction& values, const Policy& policy,
                         const Trial& trial, const std::atomic<bool>* interrupted = nullptr);

}  // namespace surefoot
