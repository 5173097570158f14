// SPDX-License-Identifier: GPL-3.0-or-later
// A second world at real time. While the learner runs at full speed, its own world would only flicker. The viewer acts
// by the newest copy of the learned values, and learns nothing itself.
#pragma once

#include <memory>
#include <vector>

#include "core/action_value.h"
#include "core/environment.h"
#include "core/life/hand.h"
#include "core/policy.h"
#include "ui/running/signal_feed.h"

namespace surefoot {

class Viewer {
 public:
  Viewer(std::unique_ptr<Environment> environment, std::unique_ptr<Policy> policy, std::uint64_t seed);

  /// Lives on for `seconds` of real time. After an ending it stands still for a moment, so that one can see it.
  void advance(double seconds, const ActionValueFunction& values);

  Environment& environment() { return *environment_; }
  const Environment& environment() const { return *environment_; }
  Policy& policy() { return *policy_; }
  void setPolicy(std::unique_ptr<Policy> policy) { policy_ = std::move(policy); }
  std::vector<double> pose() const { return environment_->pose(); }
  Action action() const { return now_.action; }
  /// Holds the body at `target`; without a target, lets go.
  void hold(std::optional<double> target) { hand_.hold(target); }
  /// Writes the signals of its steps down there; nullptr: nowhere.
  void writeTo(SignalFeed* feed) { feed_ = feed; }
  /// Counts the falls seen here.
  int falls() const { return falls_; }

 private:
  void choose(const ActionValueFunction& values);

  std::unique_ptr<Environment> environment_;
  std::unique_ptr<Policy> policy_;
  Random random_;
  MomentSeen now_;
  std::vector<double> pi_;
  Hand hand_;
  double time_ = 0.0;  // not yet lived [s]
  double rest_ = 0.0;  // standing still for this long [s]
  bool ended_ = true;
  int falls_ = 0;
  SignalFeed* feed_ = nullptr;
};

}  // namespace surefoot
