// SPDX-License-Identifier: GPL-3.0-or-later
// A learner: chooses actions and learns from what comes back.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/action_value.h"
#include "core/basics/random.h"
#include "core/basics/types.h"
#include "core/files/archive.h"
#include "core/learned_step.h"
#include "core/policy.h"

namespace surefoot {

/// Acts in place of the policy while the risk of a fall is too high (policy.guardian). Looking changes nothing.
class Guardian {
 public:
  virtual ~Guardian() = default;
  /// The action of `who` in the state that the agent is in. Hot.
  virtual Action act(GuardedBy who, std::span<const double> state) const = 0;
};

class Calibration;

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
  /// How many of the actions so far were the guardian's.
  virtual std::int64_t guarded() const { return guarded_; }
  /// What ρ said, and what came; null: it is not learned.
  virtual const Calibration* calibration() const { return nullptr; }
  /// Λ of a falls budget: what a fall costs more than the environment says; none: there is no budget.
  virtual std::optional<double> priceOfFall() const { return std::nullopt; }

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
  /// Who acts where the policy asks for a guardian; it must outlive its use.
  virtual void setGuardian(const Guardian* guardian) { guardian_ = guardian; }

 protected:
  /// What an agent chooses by in a state: the state, q̂(s, ·), and Q⁻(s, ·) where q̂ is split.
  struct Seen {
    std::span<const double> state, q, losses{};
  };
  /// An action drawn from the policy's π, which is left in `pi`, or the guardian's; counted if it explores.
  Action draw(const Seen& seen, std::span<double> pi, Random& random) {
    const ActionView view{seen.q, risk_, seen.losses};
    const auto [a, explores] = policy_->draw(view, pi, random);
    if (policy_->caution().guards() && guardian_ && !risk_.empty()) {
      isGuarded_ = policy_->caution().guards(risk_[static_cast<std::size_t>(a)], isGuarded_);
      if (isGuarded_) return guarded(seen.state, pi);
    } else {
      isGuarded_ = false;
    }
    explored_ += explores;
    return a;
  }

  /// Another episode begins: the guardian waits for a risk above the limit again.
  void startUnguarded() { isGuarded_ = false; }

  /// Part of transferLearning(); older files lack it.
  void transferChosen(Archive& archive) {
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
    if (!archive.reading() || archive.has("explored")) archive.value("explored", explored_, 0, kMost);
    if (archive.reading() ? !archive.has("guarded") : guarded_ == 0) return;
    archive.value("guarded", guarded_, 0, kMost);
    archive.value("is_guarded", isGuarded_, 0, 1);
  }

  const Policy* policy_ = nullptr;
  std::span<const double> risk_;

 private:
  /// What the guardian does, which is what is learned about: π is all on it.
  Action guarded(std::span<const double> state, std::span<double> pi) {
    ++guarded_;
    const Action a = guardian_->act(policy_->caution().guardedBy(), state);
    for (std::size_t i = 0; i < pi.size(); ++i) pi[i] = static_cast<Action>(i) == a ? 1.0 : 0.0;
    return a;
  }

  const Guardian* guardian_ = nullptr;
  std::int64_t explored_ = 0, guarded_ = 0;
  bool isGuarded_ = false;  ///< the guardian acts
};

}  // namespace surefoot
