// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/inspection/parts.h"

#include <fmt/format.h>

#include <cmath>

#include "core/text/text.h"

namespace surefoot {

namespace {

constexpr std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

std::string bodyName(const RobotSpec& spec, int body) {
  return body < 0 ? "world" : spec.bodies[at(body)].name;
}

/// "hip torque −4 … 4 N m".
std::string motorOf(const RobotSpec& spec, const Robot& robot, int joint) {
  for (const ActuatorSpec& actuator : spec.actuators) {
    if (actuator.joint != joint || actuator.levels.empty()) continue;
    double low = kInfinity, high = -kInfinity;
    for (const Formula& level : actuator.levels)
      low = std::min(low, level(robot.values().row())), high = std::max(high, level(robot.values().row()));
    return fmt::format("; {} {} … {} {}, {} levels", actuator.title, fixedText(low, 2), fixedText(high, 2),
                       actuator.unit, actuator.levels.size());
  }
  return "";
}

/// The direction in which a joint's child lies: to its centre of mass.
double directionOf(const RobotNumbers& numbers, const BodyPlacement& child, std::size_t body, Point centre) {
  const Point mass = placeOf(child, numbers.bodies[body].centre);
  return std::atan2(mass.y - centre.y, mass.x - centre.x);
}

/// Only a number that stands there as such can be dragged.
std::optional<TextPlace> numberAt(const Formula& formula) {
  const auto in = formula.expression.instructions();
  if (in.size() == 1 && in[0].operation == Operation::Constant) return formula.at;
  return std::nullopt;
}

void describeJoint(const RobotSpec& spec, const Robot& robot, const std::vector<BodyPlacement>& bodies, std::size_t j,
                   EnvironmentInspection& found) {
  const JointSpec& joint = spec.joints[j];
  const JointNumbers& numbers = robot.numbers().joints[j];
  const Point centre = placeOf(bodies[at(joint.child)], numbers.atChild);
  std::string about = fmt::format("{} to {}", bodyName(spec, joint.parent), bodyName(spec, joint.child));
  if (numbers.limits)
    about += fmt::format(", {} … {}", fixedText(numbers.limits->first, 2), fixedText(numbers.limits->second, 2));
  about += motorOf(spec, robot, static_cast<int>(j));
  found.parts.push_back({joint.name, about, centre, joint.place.line});
  if (!numbers.limits || joint.kind != JointSpec::Kind::Revolute) return;
  const double zero = directionOf(robot.numbers(), bodies[at(joint.child)], at(joint.child), centre);
  found.handles.push_back({joint.name, centre, zero, numbers.limits->first, false, numberAt((*joint.limits)[0])});
  found.handles.push_back({joint.name, centre, zero, numbers.limits->second, true, numberAt((*joint.limits)[1])});
}

}  // namespace

std::string actionsOf(const Task& task) {
  if (task.actionVariables.empty()) return fmt::format("{}: {} levels", task.actionTitle, task.actions.size());
  std::string titles, counts;
  for (const ActionVariable& v : task.actionVariables) {
    titles += (titles.empty() ? "" : ", ") + v.title;
    counts += fmt::format("{}{}", counts.empty() ? "" : " × ", v.levels.size());
  }
  return fmt::format("{}: {} = {}", titles, counts, task.actions.size());
}

void describeParts(const RobotSpec& spec, const Robot& robot, EnvironmentInspection& found) {
  const Assembly assembly(spec, robot.numbers());
  const auto bodies = assembly.placed(assembly.drawing());
  for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
    const BodyNumbers& body = robot.numbers().bodies[b];
    found.parts.push_back({spec.bodies[b].name, body.still ? "still" : fmt::format("{} kg", fixedText(body.mass, 2)),
                           placeOf(bodies[b], body.centre), spec.bodies[b].place.line});
  }
  for (std::size_t j = 0; j < spec.joints.size(); ++j) describeJoint(spec, robot, bodies, j, found);
  std::vector<double> pose;
  for (const BodyPlacement& body : bodies) pose.insert(pose.end(), {body.at.x, body.at.y, body.angle});
  pose.insert(pose.end(), spec.actuators.size() + spec.states.size(), 0.0);
  robot.draw(pose, found.drawing);
}

Trace traceOf(const RobotSpec& spec) {
  for (const EndingSpec& ending : spec.endings) {
    if (ending.kind != EndingSpec::Kind::Fall) continue;
    for (const int place : ending.when.expression.variables()) {
      const int probe = place - spec.names.firstProbe();
      if (probe >= 0 && spec.names.probes()[at(probe)].what == Probe::What::Touches) {
        const int body = spec.names.probes()[at(probe)].index;
        return {fmt::format("height of {} [m]", spec.bodies[at(body)].name), body, 0};
      }
      for (std::size_t s = 0; s < spec.states.size(); ++s)
        if (place == spec.names.placeOf(NameKind::State, static_cast<int>(s)))
          return {fmt::format("{} [{}]", spec.states[s].words.title, spec.states[s].words.unit), -1,
                  static_cast<int>(s)};
    }
  }
  return {spec.states[0].words.title, -1, 0};
}

}  // namespace surefoot
