// SPDX-License-Identifier: GPL-3.0-or-later
// From a state to where the bodies are: coordinates whose state is this one, by Levenberg's and Marquardt's method
// (damped Gauss–Newton) with differences for derivatives, from the drawing and from starts.
#pragma once

#include <optional>

#include "physics/robot/robot.h"

namespace surefoot {

class Placing {
 public:
  /// `values`: the parameters and constants that hold.
  Placing(const RobotSpec& spec, const RobotNumbers& numbers, const Assembly& assembly, std::span<const double> values);

  /// Nothing: no pose was found whose state is within kNear of its ranges. What no coordinate moves, such as whether a
  /// foot touches the ground, is left out.
  std::optional<std::vector<BodyPlacement>> bodiesFor(std::span<const double> state);
  /// The state of such bodies, with memories as at a start.
  std::vector<double> stateOf(const std::vector<BodyPlacement>& bodies);

  static constexpr double kNear = 1e-4;  ///< of a range

 private:
  struct Unknown {
    enum class What { X, Y, Angle, Vx, Vy, Rate, Joint, JointRate } what;
    std::size_t index;
  };
  static double& part(Coordinates& c, const Unknown& unknown);

  void findUnknowns();
  std::vector<double> misfit(const Coordinates& c, std::span<const double> state);
  /// The largest misfit of what moves.
  double descend(Coordinates& c, std::span<const double> state);

  const RobotSpec& spec_;
  const Assembly& assembly_;
  std::vector<double> values_, u_;
  RobotWorld world_;
  std::vector<double> low_, range_, period_;
  std::vector<Unknown> unknowns_;
};

}  // namespace surefoot
