// SPDX-License-Identifier: GPL-3.0-or-later
// A robot from a text file as an environment. In a step: the substeps, each with the efforts of its moment and the
// memories of a substep; then the memories of a step, the state, the measures, the events, the first ending that holds,
// the rewards.
#pragma once

#include <memory>
#include <string>

#include "core/environment.h"
#include "physics/robot/task/mishaps.h"
#include "physics/robot/task/robot_values.h"
#include "physics/robot/world/robot_world.h"

namespace surefoot {

class Robot final : public Environment {
 public:
  /// checkRobot() has found nothing wrong with the robot's own values.
  explicit Robot(std::shared_ptr<const RobotSpec> spec);
  ~Robot() override;

  void declare(Fields& f) override { values_.declare(f); }
  const Task& task() const override { return values_.task(); }
  void reset(Random& random) override;
  Outcome step(Action action) override;
  Action handMadeAction() const override { return values_.handMadeAction(); }
  std::span<const double> state() const override { return values_.state(); }
  std::span<const double> measures() const override { return values_.measures(); }
  std::vector<Signal> signals() const override;
  void readSignals(std::span<double> values) const override;
  bool push(double impulse) override;
  bool place(std::span<const double> state) override;
  std::vector<double> poseAt(std::span<const double> state) const override;
  /// x, y and angle of every body, the levels of the actuators, the state.
  std::vector<double> pose() const override;
  void draw(std::span<const double> pose, Scene& scene) const override;
  std::vector<ReadOut> readOuts(std::span<const double> pose) const override;
  Status check() const override;
  void parametersChanged() override;

  const RobotSpec& spec() const { return values_.spec(); }
  const RobotNumbers& numbers() const { return numbers_; }
  RobotWorld& world() { return *world_; }
  const RobotValues& values() const { return values_; }
  CutOffs cutOffs() const override { return mishaps_.counts(); }
  void setCutOffs(const CutOffs& before) override { mishaps_.setCounts(before); }
  std::string failure() const override { return mishaps_.failure(values_.spec(), values_.parameters()); }

 private:
  void rebuild();
  void begin(const std::vector<BodyPlacement>& wanted);
  bool substeps();
  Outcome flyApart();

  RobotValues values_;
  RobotNumbers numbers_;
  std::unique_ptr<Assembly> assembly_;
  std::unique_ptr<RobotWorld> world_;
  bool nowhere_ = false;  ///< the start of this episode had no numbers: its first step cuts it off
  Mishaps mishaps_;
};

/// What is wrong with a robot at its parameters' own values, its presets and scenarios; empty: nothing.
std::vector<Complaint> checkRobot(const RobotSpec& spec);

}  // namespace surefoot
