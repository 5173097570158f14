// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/world/robot_numbers.h"

#include <algorithm>
#include <cmath>

#include "core/basics/portable_math.h"
#include "physics/robot/world/checked.h"
#include "physics/robot/world/number_parts.h"

namespace surefoot {

namespace {

void readTimes(const RobotSpec& robot, RobotNumbers& numbers, CheckedNumbers& number) {
  numbers.stepTime = number(robot.stepTime, "", "step_time", 1e-5, 10, "s");
  numbers.scale = number(robot.scale, "", "scale", 0.01, 1000);
  numbers.substeps = number.whole(robot.substeps, "substeps", 1, 1000);
  numbers.velocityIterations = number.whole(robot.velocityIterations, "velocity_iterations", 1, 200);
  numbers.positionIterations = number.whole(robot.positionIterations, "position_iterations", 1, 200);
  const double gravity = number(robot.gravity, "", "gravity", -1000, 1000, "m/s²");
  const double slope = number(robot.ground.slope, "[ground]", "slope", -1.5, 1.5, "rad");
  numbers.gravity =
      slope == 0.0 ? Point{0.0, -gravity} : Point{gravity * portableSin(slope), -gravity * portableCos(slope)};
}

}  // namespace

double RobotNumbers::groundAt(double x) const {
  if (ground.size() < 2) return 0.0;
  const auto right =
      std::upper_bound(ground.begin(), ground.end(), x, [](double at, const Point& p) { return at < p.x; });
  if (right == ground.begin()) return ground.front().y;
  if (right == ground.end()) return ground.back().y;
  const Point a = *(right - 1), b = *right;
  return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
}

RobotNumbers numbersOf(const RobotSpec& robot, std::span<const double> values, std::vector<Complaint>& complaints) {
  RobotNumbers numbers;
  CheckedNumbers number(values, complaints);
  readTimes(robot, numbers, number);
  for (const BodySpec& body : robot.bodies) numbers.bodies.push_back(bodyOf(body, numbers.scale, number));
  for (const JointSpec& joint : robot.joints) numbers.joints.push_back(jointOf(joint, numbers, number));
  for (const ActuatorSpec& actuator : robot.actuators) numbers.actuators.push_back(actuatorOf(actuator, number));
  if (!robot.names.hasChild())
    for (const PointSpec& point : robot.points) numbers.points.push_back(number.at(point.at, "[point]", "at"));
  for (const RaySpec& ray : robot.rays)
    numbers.rays.emplace_back(number(ray.angle, "[ray]", "angle", -100, 100, "rad"),
                              number(ray.length, "[ray]", "length", 1e-3, 1e3, "m"));
  for (const ActuatorSpec& actuator : robot.actuators) {
    const bool soft = actuator.kind == ActuatorSpec::Kind::DcMotor || actuator.kind == ActuatorSpec::Kind::Position;
    if (soft && actuator.joint >= 0) numbers.joints[static_cast<std::size_t>(actuator.joint)].soft = true;
  }
  laidGround(robot.ground, numbers, number);
  std::size_t parts = numbers.joints.size();
  for (const BodyNumbers& body : numbers.bodies)
    for (const ShapeNumbers& shape : body.shapes) {
      ++parts;
      if (shape.meets != Meets::Nothing) numbers.anythingMeets = true;
    }
  const double work =
      1.0 * numbers.substeps * (numbers.velocityIterations + numbers.positionIterations) * static_cast<double>(parts);
  if (work > 200'000)
    number.complain(robot.substeps.at, fmt::format("substeps × iterations × (joints + shapes) is {:.0f}; at most "
                                                   "200,000 are allowed.",
                                                   work));
  return numbers;
}

}  // namespace surefoot
