// SPDX-License-Identifier: GPL-3.0-or-later
// The compass walker: two straight legs, a hip with a motor, round feet; the simplest thing that walks (after McGeer's
// passive walkers). It learns to walk in seconds of turbo.
// State: angle and rate of the stance leg, angle and rate of the swing leg [rad, rad/s; the foot forward is positive],
// which change places at every heel strike. Actions: hip torque −0.6, 0, 0.6 N m on the swing leg. Step: 40 ms.
// Rewards: footstep 200 per metre of its length, time −1 a step, fall −100.
// Ends: abs(stance) > 0.5 rad or abs(swing) > 1 rad (terminal, a fall); the step limit, 20 s (truncated).
#pragma once

#include <array>
#include <memory>

#include "core/environment.h"
#include "physics/compass/compass_world.h"

namespace surefoot {

class Compass final : public Environment {
 public:
  explicit Compass(const CompassSettings& settings = {});

  void declare(Fields& f) override { settings_.declare(f); }
  const Task& task() const override { return task_; }
  void reset(Random& random) override;
  Outcome step(Action action) override;
  std::span<const double> state() const override { return state_; }
  /// Distance of the hip [m]; footsteps forward minus footsteps back.
  std::span<const double> measures() const override { return measures_; }
  /// The impulse acts at the hip.
  bool push(double impulse) override;
  bool place(std::span<const double> state) override;
  std::vector<double> poseAt(std::span<const double> state) const override;
  /// x of the hip [m], the state, torque on the swing leg [N m], which leg stands (0 or 1).
  std::vector<double> pose() const override;
  void draw(std::span<const double> pose, Scene& scene) const override;
  std::vector<ReadOut> readOuts(std::span<const double> pose) const override;
  std::vector<Signal> signals() const override;
  void readSignals(std::span<double> values) const override;
  void parametersChanged() override;

  const CompassWorld& world() const { return *world_; }

 private:
  void resetTo(const CompassWorld::Posture& posture);
  void observe();

  CompassSettings settings_;
  Task task_;
  std::unique_ptr<CompassWorld> world_;  // a new world for every episode, so that nothing of the last one is left
  std::array<double, 4> state_{};
  double torque_ = 0.0, start_ = 0.0;
  int steps_ = 0;
  std::array<double, 2> measures_{};
};

}  // namespace surefoot
