// SPDX-License-Identifier: GPL-3.0-or-later
// One agent in one environment from its first step on: "run" in Sutton & Barto, "life" in the thesis.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/agent.h"
#include "core/environment.h"
#include "core/experiment/episode_log.h"
#include "core/random.h"
#include "core/result.h"

namespace surefoot {

struct LifeParts {
  std::unique_ptr<Environment> environment;
  std::unique_ptr<Policy> policy;
  std::unique_ptr<Agent> agent;
  Parameters parameters;  ///< complete; the parts were made from it
  std::string policyName;
};

/// Whichever comes first.
struct LifeLimits {
  std::int64_t episodes = std::numeric_limits<std::int64_t>::max();
  std::int64_t steps = std::numeric_limits<std::int64_t>::max();
};

/// Something was changed while the life went on.
struct Change {
  std::int64_t step = 0;      ///< steps of the life before it
  std::string key;            ///< of a parameter, or "policy"
  std::string before, after;  ///< as a person writes them
};

/// Used by one thread at a time.
class Life {
 public:
  Life(LifeParts parts, Random world, Random policy, LifeLimits limits, bool keepRows);

  /// One decision: the environment answers the action, the agent learns and chooses the next. Hot.
  void step();
  /// A limit is reached, or the values diverged. step() must not be called any more.
  bool finished() const { return steps_ >= limits_.steps || log_.totals().episodes >= limits_.episodes || diverged(); }
  bool diverged() const { return agent_->diverged(); }
  /// One sentence naming the parameter that most likely made the values diverge.
  std::string divergence() const;

  /// Changes one parameter: at once, or at the next episode, as it declares. A parameter that needs a new table is
  /// refused: make a new life for it.
  Status set(std::string_view key, double value);
  void setPolicy(const std::string& name, std::unique_ptr<Policy> policy);

  const Environment& environment() const { return *environment_; }
  const Agent& agent() const { return *agent_; }
  const Policy& policy() const { return *policy_; }
  const std::string& policyName() const { return policyName_; }
  const Parameters& parameters() const { return parameters_; }
  const EpisodeLog& log() const { return log_; }
  const std::vector<Change>& changes() const { return changes_; }
  const LifeLimits& limits() const { return limits_; }

  std::int64_t steps() const { return steps_; }
  /// [s]; NaN where the task has no clock.
  double simulatedSeconds() const;
  /// The action that the next step will carry out.
  Action nextAction() const { return action_; }
  bool inEpisode() const { return inEpisode_; }
  /// Every row of the log and every weight, in 64 bits.
  std::uint64_t hash() const;

 private:
  void beginEpisode();
  /// Policy and agent may follow a schedule.
  void tellTime();
  void note(const std::string& key, const std::string& before, const std::string& after);

  std::unique_ptr<Environment> environment_;
  std::unique_ptr<Policy> policy_;
  std::unique_ptr<Agent> agent_;
  Parameters parameters_;
  std::string policyName_;
  Random worldRandom_, policyRandom_;
  LifeLimits limits_;
  EpisodeLog log_;
  std::vector<Change> changes_;
  std::int64_t steps_ = 0;
  Action action_ = 0;
  bool inEpisode_ = false;
  bool environmentChanged_ = false;
  bool everyStep_ = false;  // a schedule changes with every step
};

}  // namespace surefoot
