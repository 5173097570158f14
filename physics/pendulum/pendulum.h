// SPDX-License-Identifier: GPL-3.0-or-later
// The inverted pendulum on a cart (thesis, chapter 3) in Box2D.
//
// Two bodies: the base slides along the ground (a prismatic joint), the pole turns on it (a revolute joint whose motor
// at speed 0 is the dry friction). The wheel rolls without slip, so its mass and inertia are part of the base,
//   M_e = M + m_w + I_w/R²,
// and it is only drawn, turned by x/R. The motor's force acts on the base, its damping implicit in the effective
// inertia so that one step of 5 ms is stable and second-order effects of the damping stay small:
//   F = (T − c·β̇) / (R·(1 + h·c/(M_t·R²))),  M_t = M_e + m, h the time of a substep.
// State: pole angle α [rad, 0 upright, clockwise positive], pole rate α̇ [rad/s], wheel rate β̇ = ẋ/R [rad/s].
// Actions: wheel torques −1.5, −0.75, 0, 0.75, 1.5 N m. Step: 5 ms.
// Ends: abs(α) ≥ fall angle (terminal, a fall); abs(α) and abs(α̇) within the balanced limits after a step (terminal, a
// success); the step limit (truncated).
#pragma once

#include <array>
#include <memory>

#include "core/environment.h"
#include "physics/pendulum/pendulum_settings.h"

namespace surefoot {

class PendulumWorld;

class Pendulum final : public Environment {
 public:
  explicit Pendulum(const PendulumSettings& settings = {});
  ~Pendulum() override;

  void declare(Fields& f) override { settings_.declare(f); }
  const Task& task() const override { return task_; }
  void reset(Random& random) override;
  /// Starts an episode in a given state, at x = 0.
  void resetTo(double poleAngle, double poleRate, double wheelRate);
  Outcome step(Action action) override;
  std::span<const double> state() const override { return state_; }
  /// The impulse acts at the tip of the pole, in the next step.
  bool push(double impulse) override;
  bool place(std::span<const double> state) override;
  std::vector<double> poseAt(std::span<const double> state) const override;
  /// x [m], pole angle [rad], pole rate [rad/s], wheel rate [rad/s], torque [N m].
  std::vector<double> pose() const override;
  void draw(std::span<const double> pose, Scene& scene) const override;
  std::vector<ReadOut> readOuts(std::span<const double> pose) const override;
  std::vector<Signal> signals() const override;
  void readSignals(std::span<double> values) const override;
  Status check() const override;
  void parametersChanged() override;

  /// Simulates one transition with any torque [N m]; no reward, no ending. For tests against the equations.
  void advance(double torque);
  const PendulumSettings& settings() const { return settings_; }

 private:
  void observe();

  PendulumSettings settings_;
  Task task_;
  std::unique_ptr<PendulumWorld> world_;
  std::array<double, 3> state_{};
  double torque_ = 0.0;  // torque of the last action, scaled [N m]
  int steps_ = 0;
};

}  // namespace surefoot
