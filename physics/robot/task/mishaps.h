// SPDX-License-Identifier: GPL-3.0-or-later
// Episodes that were cut off because a robot flew apart, or a formula of its file came to a number that is none. After
// many in a row the robot cannot go on.
#pragma once

#include <span>
#include <string>

#include "core/environment.h"
#include "physics/robot/task/robot_values.h"

namespace surefoot {

class Mishaps {
 public:
  /// Cuts an episode off; the state stays the last that was a number.
  Outcome cutOff(RobotValues& values);
  /// An episode ended as it should.
  void wentWell() { counts_.inARow = 0; }

  const Environment::CutOffs& counts() const { return counts_; }
  void setCounts(const Environment::CutOffs& counts) { counts_ = counts; }
  /// Why no further episode is possible, in one sentence; empty: it is.
  std::string failure(const RobotSpec& spec, std::span<const double> parameters) const;

 private:
  static constexpr int kMostInARow = 100;
  Environment::CutOffs counts_;
  std::string notFinite_;  ///< the last time
};

}  // namespace surefoot
