// SPDX-License-Identifier: GPL-3.0-or-later
// Carries a learned function over into another representation, as accurately as this one can.
#pragma once

#include <atomic>

#include "core/agent.h"
#include "core/environment.h"

namespace surefoot {

/// How far the new function is from the old one: over new states, drawn uniformly from the range of the state, and over
/// the visited states among them.
struct CarriedError {
  double rms = 0.0, largest = 0.0, rmsVisited = 0.0;
  std::int64_t visited = 0, states = 0;
};

/// Fits `to` to `from` by the method of Kaczmarz (1937): at one state after the other the whole error is closed, in
/// several passes with shrinking steps. Each estimate of the two is fitted to its counterpart; visits go along.
/// Deterministic. The two must have the same actions and the same estimates.
/// `interrupted`, set by anyone, ends it early.
CarriedError carryOver(const ActionValueFunction& from, Agent& to, const Task& task,
                       const std::atomic<bool>* interrupted = nullptr);

}  // namespace surefoot
