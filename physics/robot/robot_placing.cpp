// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/placing.h"

namespace surefoot {

bool Robot::place(std::span<const double> state) {
  const auto bodies = Placing(spec(), numbers_, *assembly_, values_.row()).bodiesFor(state);
  if (!bodies) return false;
  begin(*bodies);
  return true;
}

std::vector<double> Robot::poseAt(std::span<const double> state) const {
  const auto bodies = Placing(spec(), numbers_, *assembly_, values_.row()).bodiesFor(state);
  if (!bodies) return {};
  std::vector<double> pose;
  for (const BodyPlacement& body : *bodies) pose.insert(pose.end(), {body.at.x, body.at.y, body.angle});
  pose.insert(pose.end(), values_.levels().size(), 0.0);
  pose.insert(pose.end(), state.begin(), state.end());
  return pose;
}

}  // namespace surefoot
