// SPDX-License-Identifier: GPL-3.0-or-later
// A learner: chooses actions and learns from what comes back.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/action_value.h"
#include "core/basics/random.h"
#include "core/basics/types.h"
#include "core/files/archive.h"
#include "core/learned_step.h"
#include "core/policy.h"

namespace surefoot {

/// One episode is start, step, step, …, then end or truncate. Used by one thread. Everything random comes from the
/// generator handed in; looking (const) changes nothing. None of the four calls allocates or locks.
class Agent : public Scheduling {
 public:
  /// The first action of an episode, in state s.
  virtual Action start(std::span<const double> state, Random& random) = 0;
  /// Learns from the outcome of the last action and chooses the next in the state it led to. Hot.
  virtual Action step(const Outcome& outcome, std::span<const double> state, Random& random) = 0;
  /// Learns from a terminal outcome: the value of the state after it is 0.
  virtual void end(const Outcome& outcome) = 0;
  /// Learns from an outcome cut off by a time limit: the value of `state`, where it would have gone on, is estimated.
  /// Returns the action that would have been taken there.
  virtual Action truncate(const Outcome& outcome, std::span<const double> state, Random& random) = 0;

  /// The episode is given up: nothing is learned from its last action any more.
  virtual void abandon() = 0;

  virtual const ActionValueFunction& values() const = 0;
  /// z of the weights that have a trace, for display.
  virtual void eligibility(std::vector<Eligibility>& z) const = 0;
  /// The last learning step of each estimate.
  virtual std::vector<NamedStep> lastSteps() const = 0;
  /// The values have left any sensible range; the life should stop.
  virtual bool diverged() const = 0;
  /// How many states so far lay outside the range that the features cover.
  virtual std::int64_t statesOutside() const = 0;
  /// How many of the actions so far were not the best by q̂: the agent explored. Counted from when it was made.
  virtual std::int64_t explored() const { return explored_; }

  /// The estimates by name, with the layout of their features. A file fits this agent only if its layouts are the same.
  virtual Json layouts() const = 0;
  /// Moves q̂(s, ·) of one layer towards `q`, closing the given share of the error, and counts its features as visited
  /// at least so often. For carrying a function over into this agent's representation; not a learning step.
  virtual void fit(std::span<const double> state, Layer layer, std::span<const double> q, double share,
                   double visits) = 0;
  /// Writes or reads the learned tables of the estimates.
  virtual void transferValues(Archive& archive) = 0;
  /// Writes or reads everything else that a life needs to go on in the middle of an episode.
  virtual void transferLearning(Archive& archive) = 0;

  /// Where the risk of each action in the next state stands when an action is chosen; it must outlive its use.
  virtual void showRisk(std::span<const double> risk) { risk_ = risk; }
  /// The policy from the next choice on. It must outlive its use.
  virtual void setPolicy(const Policy& policy) { policy_ = &policy; }

 protected:
  /// An action drawn from the policy's π, which is left in `pi`; counted if it explores.
  Action draw(std::span<const double> q, std::span<const double> losses, std::span<double> pi, Random& random) {
    const ActionView view{q, risk_, losses};
    policy_->probabilities(view, pi);
    const Action a = sample(pi, random);
    explored_ += policy_->explores(view, a);
    return a;
  }

  /// Part of transferLearning(); older files lack it.
  void transferExplored(Archive& archive) {
    if (!archive.reading() || archive.has("explored"))
      archive.value("explored", explored_, 0, std::numeric_limits<std::int64_t>::max());
  }

  const Policy* policy_ = nullptr;
  std::span<const double> risk_;

 private:
  std::int64_t explored_ = 0;
};

}  // namespace surefoot
