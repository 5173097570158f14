// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a window shows of a life, as plain values.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/action_value.h"
#include "core/calibration.h"
#include "core/life/learning_curve.h"
#include "core/life/life.h"
#include "core/life/rule_of_thumb.h"
#include "core/values_of_state.h"

namespace surefoot {

/// A moment of a world, and what a learner says of it.
struct MomentSeen : ValuesOfState {
  std::vector<double> state{}, signals{}, measures{};  ///< Environment::readSignals and measures
  Action action = kNoAction;                           ///< of the next step; kNoAction: between two episodes

  void look(const Environment& environment, const ActionValueFunction& values);
};

/// A step that was seen: the moment before its action, and what the action brought.
struct StepSeen : MomentSeen {
  std::int64_t steps = 0, episode = 1;  ///< steps of the life before it
  Outcome outcome{};
};

/// The moment: small, sent for every frame.
struct Snapshot : MomentSeen {
  std::uint64_t life = 0;  ///< counts the lives that were put into the window
  std::int64_t steps = 0;
  double simulatedSeconds = 0;  ///< NaN: no clock
  LifeTotals totals;
  double averageReward = 0;
  std::vector<double> pose;
  std::vector<double> fallenPose;   ///< pose of the last fall, unless turbo was on
  std::vector<double> qPositive;    ///< Q⁺(s, ·), where the agent keeps it apart; else empty
  std::vector<StepSeen> seen;       ///< if wanted, the steps since the snapshot before; some may come twice
  std::vector<NamedStep> learned;   ///< what the estimates learned in the last step
  std::vector<double> stateBefore;  ///< the state in which that step was made; empty in turbo
  Action actionBefore = kNoAction;  ///< the action of that step
  bool running = false, turbo = false;
  double pace = 1.0;                 ///< the pace in force now
  bool finished = false;             ///< the limit that was asked for is reached
  std::string trouble;               ///< why it had to stop before, or empty
  std::int64_t flewApart = 0;        ///< Environment::cutOffs
  std::string unanswered{};          ///< Life::unanswered: it stands still, and can be told to run again
  std::int64_t unansweredTries = 0;  ///< how often that has happened
};

/// Everything learned so far: large, sent a few times a second and only while a panel needs it.
struct ValueSnapshot {
  std::uint64_t life = 0;
  std::int64_t steps = 0;
  double simulatedSeconds = 0;   ///< NaN: no clock
  LifeTotals totals;             ///< totals at the moment of the curve
  std::int64_t fallsByHand = 0;  ///< falls in episodes in which a person placed or pushed the body
  std::unique_ptr<ActionValueFunction> values;
  Json layouts;  ///< Agent::layouts(): where its features lie
  std::vector<Eligibility> eligibility;
  std::vector<CurvePoint> curve;
  std::string policy;  ///< the policy in force in the last episode of the curve
  std::vector<Change> changes;
  std::int64_t endOfLearning = 0;                  ///< episode, 0: not yet
  std::int64_t endOfLearningSteps = 0;             ///< steps of the life until then
  std::optional<RuleOfThumb> rule;                 ///< TRL's threshold by eq. 4.3
  std::vector<GreedyTest> tests;                   ///< tests of the greedy policy, thinned out if there are many
  std::optional<double> walksSince;                ///< [min]: time of the first test in which the robot walked
  std::vector<MemoryUse> memory;                   ///< memory of each table
  std::optional<Calibration::Report> calibration;  ///< of the risk, where it is learned
  std::int64_t guarded = 0;                        ///< actions of the guardian
  std::optional<double> priceOfFall;               ///< of a falls budget
};

}  // namespace surefoot
