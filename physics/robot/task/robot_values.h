// SPDX-License-Identifier: GPL-3.0-or-later
// A robot in numbers: one row, in which RobotNames gives every name its place, and what the robot's file computes with
// it: constants, actions, memories, state, measures, endings, rewards. What is measured of a moving robot is filled in
// by whoever moves it. A memory that names a state finds that of the step before; an effort finds the state that the
// learner saw.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/environment.h"
#include "physics/robot/spec/robot_spec.h"

namespace surefoot {

/// The task of a robot under these values.
Task robotTask(const RobotSpec& spec, std::span<const double> values);

class RobotValues {
 public:
  explicit RobotValues(std::shared_ptr<const RobotSpec> spec);

  const RobotSpec& spec() const { return *spec_; }
  void declare(Fields& f);
  /// The parameters of another one of the same robot.
  void takeParametersOf(const RobotValues& other);
  std::span<const double> parameters() const { return std::span(row_).first(whole_.size()); }
  void computeConstants();
  /// Parameters were changed and constants computed: the task of these.
  void renewTask();

  std::span<double> row() { return row_; }
  std::span<const double> row() const { return row_; }
  const Task& task() const { return task_; }
  std::span<const double> state() const { return state_; }
  std::span<const double> measures() const { return measures_; }
  std::span<const double> levels() const { return u_; }  ///< of all actuators
  /// The actuators with levels, in the order of the task's action variables.
  const std::vector<std::size_t>& driven() const { return driven_; }
  int steps() const { return steps_; }
  int stepLimit() const { return maxSteps_; }
  /// The ending of the last step, by its number in the file; −1: none of them.
  int lastEnding() const { return lastEnding_; }
  void forgetEnding() { lastEnding_ = -1; }

  /// An episode begins: the clock stands at 0, no actuator acts, memories are as they start.
  void startEpisode();
  /// What is measured of the robot has been filled in: the other memories, state, potentials and measures of the start.
  /// False: see notFinite().
  bool settle();

  /// A step begins: the levels of an action.
  void decide(Action action);
  /// The action that is nearest to what the hand-made controller commands now. Hot.
  Action handMadeAction() const;
  void setTime(double seconds) { row_[stepAt_ + 1] = seconds; }
  void remember(bool substep);
  bool remembersSubsteps() const { return inSubsteps_; }
  /// The clock after another step.
  void tick();
  /// What is measured has been filled in after a step: memories, state, measures, and what has come of it. False: see
  /// notFinite().
  bool judge(Outcome& outcome);
  /// What came to a number that is none in the last settle() or judge(), "the state speed"; the state is still the last
  /// that was one. Empty: nothing.
  const std::string& notFinite() const { return notFinite_; }
  /// The state is kept as it was seen last.
  void keepState(std::vector<double> state) { state_ = std::move(state); }

 private:
  bool observe();
  bool measure(bool first);
  bool reward(Outcome& outcome);
  double valueOf(std::size_t reward);
  double handMade(std::size_t actuator) const;

  std::shared_ptr<const RobotSpec> spec_;
  std::vector<double> row_;
  std::size_t constantsAt_, memoriesAt_, statesAt_, stepAt_;  ///< time stands behind step
  std::vector<int> whole_;                                    ///< parameters that are whole numbers
  std::vector<std::size_t> driven_;
  std::vector<std::size_t> live_;  ///< constants of rewards: they follow a change at once
  Task task_;
  std::vector<double> u_, potentials_, state_, measures_;
  std::string notFinite_;
  bool inSubsteps_ = false;  ///< some memories are of a substep
  int steps_ = 0, maxSteps_ = 0, lastEnding_ = -1;
};

}  // namespace surefoot
