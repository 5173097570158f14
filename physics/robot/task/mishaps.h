// SPDX-License-Identifier: GPL-3.0-or-later
// Episodes that were cut off because a robot flew apart, or a formula of its file came to a number that is none. After
// many in a row the robot cannot go on.
#pragma once

#include <cstdint>
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
  void wentWell() { inARow_ = 0; }

  std::int64_t count() const { return count_; }
  /// Why no further episode is possible, in one sentence; empty: it is.
  std::string failure(const RobotSpec& spec, std::span<const double> parameters) const;

 private:
  static constexpr int kMostInARow = 100;
  std::int64_t count_ = 0;
  int inARow_ = 0;
  std::string notFinite_;  ///< the last time
};

}  // namespace surefoot
