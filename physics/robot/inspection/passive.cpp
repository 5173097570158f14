// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/inspection/passive.h"

#include <algorithm>
#include <cmath>

namespace surefoot {

std::shared_ptr<const RobotSpec> passiveRobot(const RobotSpec& spec, int finer) {
  auto passive = std::make_shared<RobotSpec>(spec);
  for (JointSpec& joint : passive->joints) {
    joint.damping = joint.armature = joint.stiffness = std::nullopt;
    joint.limits = joint.stop = std::nullopt;
    joint.friction = joint.rest = formulaOf(0);
    joint.soft = false;
  }
  for (ActuatorSpec& actuator : passive->actuators) {
    actuator.kind = actuator.point >= 0 ? ActuatorSpec::Kind::Force : ActuatorSpec::Kind::Torque;
    actuator.effort = formulaOf(0);
    actuator.limit = std::nullopt;
  }
  for (BodySpec& body : passive->bodies)
    for (ShapeSpec& shape : body.shapes) shape.meets = Meets::Nothing, shape.solid = std::nullopt;
  // A start with energy: what can turn without end is turned far from where it hangs or stands.
  for (std::size_t j = 0; j < spec.joints.size(); ++j)
    if (spec.joints[j].kind == JointSpec::Kind::Revolute && !spec.joints[j].limits)
      passive->start.push_back(
          {.ofBody = false, .index = static_cast<int>(j), .what = StartSpec::What::Position, .value = formulaOf(2.0)});
  const double substeps = spec.substeps(Robot(std::make_shared<RobotSpec>(spec)).values().row());
  passive->substeps = formulaOf(std::min(1000.0, substeps * finer));
  passive->onGround = false;
  passive->atRest = -1;
  return passive;
}

std::shared_ptr<const RobotSpec> droppedRobot(const RobotSpec& spec) {
  constexpr double kHeight = 0.2;  // [m]
  auto dropped = std::make_shared<RobotSpec>(spec);
  dropped->start.clear();
  dropped->onGround = false;
  dropped->atRest = -1;
  const Robot robot(std::make_shared<RobotSpec>(spec));
  const Assembly assembly(spec, robot.numbers());
  for (std::size_t b = 0; b < spec.bodies.size(); ++b)
    if (assembly.isFree(static_cast<int>(b)) && !spec.bodies[b].still)
      dropped->start.push_back({.ofBody = true,
                                .index = static_cast<int>(b),
                                .what = StartSpec::What::Y,
                                .value = formulaOf(spec.bodies[b].at[1](robot.values().row()) + kHeight)});
  return dropped;
}

PassiveEnergy energyOf(const std::shared_ptr<const RobotSpec>& spec) {
  constexpr double kSeconds = 4.0;
  Robot robot(spec);
  Random random(1);
  robot.reset(random);
  PassiveEnergy energy;
  energy.begins = energy.ends = robot.world().energy();
  const int steps = std::max(1, static_cast<int>(kSeconds / robot.numbers().stepTime));
  for (int i = 0; i < steps && robot.cutOffs().all == 0; ++i) {
    robot.step(0);
    energy.ends = robot.world().energy();
    energy.largestMotion = std::max(energy.largestMotion, robot.world().motion());
    energy.seconds += robot.numbers().stepTime;
  }
  return energy;
}

}  // namespace surefoot
