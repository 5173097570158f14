// SPDX-License-Identifier: GPL-3.0-or-later
// LEO, the walking robot of the Delft laboratory, in the plane: the robot that the thesis is for, on the task of
// wcaarls/grl (addons/leosim).
//
// State (10): angle and rate of the torso, the stance hip, the swing hip, the stance knee and the swing knee [rad,
// rad/s]. The stance leg is the leg on the floor. With both on the floor, it is the leg whose ankle is in front; with
// none, it stays the same. A change of it is a footstep.
// Actions (343): voltages of stance hip, swing hip and swing knee, 7 levels of each. The stance knee (21.21 V/rad
// towards 0) and both ankles (42.42 V/rad towards 3.72°) look after themselves. Step: 1/30 s.
// Rewards: time −1 a step; energy −3 a joule that hips and knees take; footstep +300·(L − L_before), L the distance of
// the ankles [m], swing minus stance, of the legs as they were before the step; behind a footstep L_before = −L; fall
// −125 when doomed. Measures: how far the hip got; footsteps forward less those back, which tells a walk from a limp
// that drags one toe behind the other foot; the energy of hips and knees. Ends: abs(torso) > 1 rad or abs(torso +
// stance hip) > 0.36π, doomed (terminal, a fall); the step limit (truncated).
#pragma once

#include <array>
#include <memory>

#include "core/environment.h"
#include "physics/leo/leo_world.h"

namespace surefoot {

class Leo final : public Environment {
 public:
  explicit Leo(const LeoSettings& settings = {});

  void declare(Fields& f) override { settings_.declare(f); }
  const Task& task() const override { return task_; }
  void reset(Random& random) override;
  Outcome step(Action action) override;
  Action handMadeAction() const override;
  std::span<const double> state() const override { return state_; }
  std::span<const double> measures() const override { return measures_; }
  /// The impulse acts at the hip.
  bool push(double impulse) override;
  bool place(std::span<const double> state) override;
  std::vector<double> poseAt(std::span<const double> state) const override;
  /// Hip x and y [m], the angles of all bodies [rad], three voltages [V], stance leg, left and right foot on the floor,
  /// net footsteps, mean speed of the episode [m/s].
  std::vector<double> pose() const override;
  void draw(std::span<const double> pose, Scene& scene) const override;
  std::vector<ReadOut> readOuts(std::span<const double> pose) const override;
  /// Of every joint angle, rate, voltage, current and power; what the feet touch; where the hip is and how fast.
  std::vector<Signal> signals() const override;
  void readSignals(std::span<double> values) const override;
  void parametersChanged() override;

  const LeoWorld& world() const { return *world_; }
  int stanceLeg() const { return stance_; }

 private:
  using Command = std::array<double, 3>;  // stance hip, swing hip, swing knee [V]

  void begin(const LeoWorld::Angles& angles, const LeoWorld::Angles& rates);
  void observe();
  double ankleDistance() const;
  int supportingLeg() const;
  Command commandOf(Action action) const;
  Command handMade() const;
  LeoWorld::Voltages voltagesFor(const Command& command) const;

  LeoSettings settings_;
  Task task_;
  std::unique_ptr<LeoWorld> world_;  // a new world for every episode, so that nothing of the last one is left
  std::array<double, 10> state_{};
  Command command_{};
  int stance_ = 0, steps_ = 0;
  int sinceFootstep_ = 0;       // steps since the last footstep of positive length
  bool swingsForward_ = false;  // such a footstep was made in this episode
  double distance_ = 0.0;       // L_before [m]
  double start_ = 0.0;          // x of the hip when the episode began [m]
  std::array<double, 3> measures_{};
};

}  // namespace surefoot
