// SPDX-License-Identifier: GPL-3.0-or-later
// Which threshold to choose for TRL (thesis, section 4.3): the value that the first pair of a successful episode will
// have.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "core/life/life.h"

namespace surefoot {

/// eq. 4.1 and 4.3: γ^n*·R_goal + Σ_{k=1..n*} γ^k·R_time, n* the mean transitions of the successful episodes during
/// learning, any positive real, so that the sum is γ(1 − γ^n*)/(1 − γ)·R_time, or n*·R_time for γ = 1. (By eq. 2.6 the
/// first pair is worth γ^(n* − 1)·R; this is the thesis's exponent.)
inline double ruleOfThumb(double discount, double transitions, double goalReward, double timeReward) {
  const double power = std::pow(discount, transitions);
  const double steps = discount < 1.0 ? discount * (1.0 - power) / (1.0 - discount) : transitions;
  return power * goalReward + steps * timeReward;
}

/// The rule with the episodes of a life so far (thesis, section 4.3): n* is the mean of the transitions of its
/// successful episodes, of all of them while learning goes on. Without pre-learning the episodes during learning give
/// the lower limit of the threshold, and the episodes after it the upper limit; after pre-learning there are no limits.
struct RuleOfThumb {
  double threshold = 0.0, transitions = 0.0;
  double discount = 1.0, reward = 0.0, timeReward = 0.0;  ///< γ, R_goal and R_time in the formula
  bool goal = true;  ///< false: R_goal stands for the highest reward of a transition, n* for those of a net footstep
  std::optional<double> lower{}, upper{};  ///< none without successes in that part, or after pre-learning
  bool preLearned = false;
};

/// A task without a goal uses the highest intermediate reward instead (thesis, section 4.5; expected there, not
/// tested): for a walking task, R_goal is the highest reward of a transition so far and n* the transitions of a net
/// footstep. None if the task has neither, without a discount, or before the first success.
std::optional<RuleOfThumb> ruleOfThumbOf(const Life& life);

/// Why there is no rule, or none yet, as a sentence.
std::string whyNoRule(const Task& task, const Parameters& parameters);

/// The rule as a person reads it. n* and the rewards have as many decimals as the formula needs to give the threshold
/// beside it.
struct RuleText {
  std::string threshold;    ///< "66.8"
  std::string transitions;  ///< "54.3"
  std::string symbols;      ///< "γ^n* · R"
  std::string formula;      ///< "0.98^54.3 · 200"
};
RuleText textOf(const RuleOfThumb& rule);

}  // namespace surefoot
