// SPDX-License-Identifier: GPL-3.0-or-later
// Visits every formula of a robot.
#pragma once

#include "physics/robot/spec/robot_spec.h"

namespace surefoot {

template <class Visit>
void forEveryFormula(const RobotSpec& robot, Visit visit) {
  const auto maybe = [&](const std::optional<Formula>& formula) {
    if (formula) visit(*formula);
  };
  const auto pair = [&](const FormulaPair& both) { visit(both[0]), visit(both[1]); };
  const auto maybePair = [&](const std::optional<FormulaPair>& both) {
    if (both) pair(*both);
  };
  for (const Formula* f : {&robot.stepTime, &robot.substeps, &robot.velocityIterations, &robot.positionIterations,
                           &robot.gravity, &robot.scale, &robot.maxSteps, &robot.testEvery})
    visit(*f);
  pair(robot.returns);
  for (const ConstantSpec& constant : robot.constants) visit(constant.value);
  for (const BodySpec& body : robot.bodies) {
    pair(body.at), visit(body.angle);
    maybe(body.mass), maybe(body.inertia), maybe(body.inertiaAtOrigin), maybePair(body.centre);
    for (const ShapeSpec& shape : body.shapes) {
      for (const Formula* f : {&shape.radius, &shape.angle, &shape.friction, &shape.restitution, &shape.density})
        visit(*f);
      pair(shape.size), pair(shape.at), pair(shape.to), maybe(shape.solid);
      for (const FormulaPair& corner : shape.corners) pair(corner);
    }
  }
  for (const PointSpec& point : robot.points) pair(point.at);
  for (const RaySpec& ray : robot.rays) visit(ray.angle), visit(ray.length);
  for (const JointSpec& joint : robot.joints) {
    pair(joint.at), pair(joint.to), pair(joint.axis), maybePair(joint.limits), maybePair(joint.stop);
    maybe(joint.damping), maybe(joint.armature), maybe(joint.stiffness), visit(joint.friction), visit(joint.rest);
  }
  for (const ActuatorSpec& a : robot.actuators) {
    pair(a.direction), maybe(a.effort), maybe(a.handMade), maybe(a.limit), maybe(a.width);
    for (const Formula* f : {&a.resistance, &a.torqueConstant, &a.gear, &a.efficiency, &a.stiffness, &a.damping})
      visit(*f);
    for (const Formula& level : a.levels) visit(level);
  }
  const GroundSpec& ground = robot.ground;
  for (const Formula* f :
       {&ground.friction, &ground.slope, &ground.length, &ground.height, &ground.from, &ground.to, &ground.seed})
    visit(*f);
  for (const FormulaPair& point : ground.points) pair(point);
  for (const MemorySpec& memory : robot.memories) visit(memory.start), visit(memory.each);
  for (const StateSpec& state : robot.states) {
    visit(state.value), pair(state.range), maybePair(state.view);
    maybe(state.width), maybe(state.resolution), maybe(state.span);
  }
  for (const StartSpec& start : robot.start) visit(start.value);
  for (const auto* endings : {&robot.endings, &robot.events})
    for (const EndingSpec& ending : *endings) visit(ending.when);
  for (const RewardSpec& reward : robot.rewards) visit(reward.value), maybe(reward.when);
  for (const MeasureSpec& measure : robot.measures) visit(measure.value);
  maybe(robot.picture.height), maybe(robot.picture.width);
}

}  // namespace surefoot
