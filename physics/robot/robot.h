// SPDX-License-Identifier: GPL-3.0-or-later
// A robot from a text file as an environment. In a step: the substeps, each with the efforts of its moment and the
// memories of a substep; then the memories of a step, the state, the measures, the events, the first ending that holds,
// the rewards. A memory that names a state finds that of the step before; an effort finds the state that the learner
// saw.
#pragma once

#include <memory>
#include <string>

#include "core/environment.h"
#include "physics/robot/world/robot_world.h"

namespace surefoot {

class Robot final : public Environment {
 public:
  /// checkRobot() has found nothing wrong with the robot's own values.
  explicit Robot(std::shared_ptr<const RobotSpec> spec);
  ~Robot() override;

  void declare(Fields& f) override;
  const Task& task() const override { return task_; }
  void reset(Random& random) override;
  Outcome step(Action action) override;
  std::span<const double> state() const override { return state_; }
  std::span<const double> measures() const override { return measures_; }
  bool push(double impulse) override;
  bool place(std::span<const double> state) override;
  std::vector<double> poseAt(std::span<const double> state) const override;
  /// x, y and angle of every body, the levels of the actuators, the state.
  std::vector<double> pose() const override;
  void draw(std::span<const double> pose, Scene& scene) const override;
  std::vector<ReadOut> readOuts(std::span<const double> pose) const override;
  Status check() const override;
  void parametersChanged() override;

  const RobotSpec& spec() const { return *spec_; }
  const RobotNumbers& numbers() const { return numbers_; }
  RobotWorld& world() { return *world_; }
  std::span<const double> values() const { return values_; }
  std::int64_t flewApart() const override { return flewApart_; }
  /// kMostInARow episodes flew apart, one after the other.
  std::string failure() const override;
  /// The ending of the last step, by its number in the file; −1: none of them.
  int lastEnding() const { return lastEnding_; }
  int stepLimit() const { return maxSteps_; }

 private:
  void computeConstants();
  void rebuild();
  void begin(const std::vector<BodyPlacement>& wanted);
  void observe();
  void decide(Action action);
  bool substeps();
  void remember(bool substep);
  void measure(bool first);
  Outcome judged();
  double valueOf(std::size_t reward);

  std::shared_ptr<const RobotSpec> spec_;
  std::vector<double> values_;                                ///< at the places of RobotNames:
  std::size_t constantsAt_, memoriesAt_, statesAt_, stepAt_;  ///< time stands behind step
  std::vector<int> whole_;                                    ///< parameters that are whole numbers
  RobotNumbers numbers_;
  Task task_;
  std::unique_ptr<Assembly> assembly_;
  std::unique_ptr<RobotWorld> world_;
  std::vector<std::size_t> driven_;  ///< the actuators with levels, in the order of the task's action variables
  std::vector<std::size_t> live_;    ///< constants of rewards: they follow a change at once
  std::vector<double> u_, potentials_, state_, measures_;
  bool nowhere_ = false;     ///< the start of this episode had no numbers: its first step cuts it off
  bool inSubsteps_ = false;  ///< some memories are of a substep
  int steps_ = 0, maxSteps_ = 0, lastEnding_ = -1;
  static constexpr int kMostInARow = 100;
  std::int64_t flewApart_ = 0;
  int inARow_ = 0;  ///< episodes that flew apart
};

/// What is wrong with a robot at its parameters' own values, its presets and scenarios; empty: nothing.
std::vector<Complaint> checkRobot(const RobotSpec& spec);

/// The task of a robot under these values.
Task robotTask(const RobotSpec& spec, std::span<const double> values);

}  // namespace surefoot
