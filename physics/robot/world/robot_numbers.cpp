// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/world/robot_numbers.h"

#include <algorithm>
#include <cmath>

#include "core/basics/portable_math.h"
#include "physics/robot/world/checked.h"
#include "physics/robot/world/masses.h"

namespace surefoot {

namespace {

constexpr double kMost = 1e9;             // of whatever has no better bound
constexpr double kSmallestRadius = 1e-5;  // [m]

Point rotated(Point v, double angle) {
  const double c = portableCos(angle), s = portableSin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

double length(Point v) {
  return std::sqrt(v.x * v.x + v.y * v.y);
}

ShapeNumbers shapeOf(const ShapeSpec& spec, const std::string& where, CheckedNumbers& number) {
  using Form = ShapeSpec::Kind;
  ShapeNumbers shape{.kind = spec.kind, .meets = spec.meets};
  shape.at = number.at(spec.at, where, "at");
  shape.angle = number(spec.angle, where, "angle", -100, 100, "rad");
  shape.friction = number(spec.friction, where, "friction", 0, 1000);
  shape.restitution = number(spec.restitution, where, "restitution", 0, 1);
  if (spec.kind == Form::Circle || spec.kind == Form::Rod)
    shape.radius = number(spec.radius, where, spec.kind == Form::Rod ? "rod" : "circle", kSmallestRadius, 1e3, "m");
  if (spec.kind == Form::Rod) {
    shape.to = number.at(spec.to, where, "to");
    if (length({shape.to.x - shape.at.x, shape.to.y - shape.at.y}) < kSmallestRadius)
      number.complain(spec.place, where + ": a rod's two ends are at one place.");
  }
  if (spec.kind == Form::Box)
    shape.size = {number(spec.size[0], where, "box", kSmallestRadius, 1e4, "m"),
                  number(spec.size[1], where, "box", kSmallestRadius, 1e4, "m")};
  for (const FormulaPair& corner : spec.corners) shape.corners.push_back(number.at(corner, where, "polygon"));
  if (spec.kind == Form::Polygon) {
    if (std::abs(signedArea(shape.corners)) < 2e-8 || !isConvex(shape.corners))
      number.complain(spec.place, where + ": a polygon is convex and has an area; cut others into several.");
    else if (signedArea(shape.corners) < 0)
      std::reverse(shape.corners.begin(), shape.corners.end());
  }
  return shape;
}

/// Mass, centre and inertia: as given, or from the density of the shapes.
void weigh(const BodySpec& spec, const std::string& where, CheckedNumbers& number, BodyNumbers& body) {
  if (spec.still) return;
  const std::size_t wrong = number.wrong();
  MassOf dense;
  for (std::size_t i = 0; i < spec.shapes.size() && !spec.mass; ++i)
    dense.add(massOf(body.shapes[i], number(spec.shapes[i].density, where, "density", 0, 1e6, "kg/m²")));
  body.mass = spec.mass ? number(*spec.mass, where, "mass", 1e-6, 1e6, "kg") : dense.mass;
  body.centre = spec.centre ? number.at(*spec.centre, where, "centre") : dense.centre;
  body.inertiaAtOrigin = dense.inertia;
  const double arm = body.mass * (body.centre.x * body.centre.x + body.centre.y * body.centre.y);
  if (spec.inertia) body.inertiaAtOrigin = number(*spec.inertia, where, "inertia", 0, kMost, "kg m²") + arm;
  if (spec.inertiaAtOrigin)
    body.inertiaAtOrigin = number(*spec.inertiaAtOrigin, where, "inertia_at_origin", 0, kMost, "kg m²");
  if (!(body.mass >= 1e-6 && body.mass <= 1e6))
    number.complain(spec.place,
                    fmt::format("{}: its shapes weigh {} kg; allowed is 0.000001 … 1,000,000 kg.", where, body.mass));
  if (!body.rotates || number.wrong() > wrong) return;
  const double about = body.inertiaAtOrigin - arm;
  // Single precision: what is left of a difference of large numbers must still be a number.
  if (!(about > 0.0 && about > 1e-5 * arm && about >= 1e-12))
    number.complain(spec.inertia           ? spec.inertia->at
                    : spec.inertiaAtOrigin ? spec.inertiaAtOrigin->at
                                           : spec.place,
                    fmt::format("{}: its inertia about the centre of mass is {} kg m²; it must be above 0, and above "
                                "a hundred-thousandth of mass times the square of the centre's distance.",
                                where, about));
}

/// Box2D takes corners that are nearer than half its slop for one, and wants three of them.
void checkSize(const ShapeSpec& spec, const ShapeNumbers& shape, double scale, const std::string& where,
               CheckedNumbers& number) {
  constexpr double kNearest = 0.003, kSmallestArea = 1e-6, kLargest = 1e5;  // in Box2D's units
  if (shape.meets == Meets::Nothing) return;
  if (shape.kind == ShapeSpec::Kind::Circle) {
    if (!(shape.radius * scale < kLargest)) number.complain(spec.place, where + ": the shape is too large for scale.");
    return;
  }
  const std::vector<Point> corners = cornersOf(shape);
  bool fine = std::abs(signedArea(corners)) * scale * scale > kSmallestArea;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    fine &= std::abs(corners[i].x) * scale < kLargest && std::abs(corners[i].y) * scale < kLargest;
    for (std::size_t k = 0; k < i; ++k)
      fine &= length({corners[i].x - corners[k].x, corners[i].y - corners[k].y}) * scale > kNearest;
  }
  if (!fine)
    number.complain(spec.place,
                    fmt::format("{}: two corners of a shape that meets something must be {} m apart, and none "
                                "be farther than {} m (with a larger scale they may be nearer).",
                                where, kNearest / scale, kLargest / scale));
}

BodyNumbers bodyOf(const BodySpec& spec, double scale, CheckedNumbers& number) {
  const std::string where = fmt::format("[body.{}]", spec.name);
  BodyNumbers body{.rotates = spec.rotates, .still = spec.still};
  body.at = number.at(spec.at, where, "at");
  body.angle = number(spec.angle, where, "angle", -100, 100, "rad");
  for (const ShapeSpec& shape : spec.shapes) {
    const std::size_t wrong = number.wrong();
    body.shapes.push_back(shapeOf(shape, where, number));
    if (number.wrong() == wrong) checkSize(shape, body.shapes.back(), scale, where, number);
  }
  weigh(spec, where, number, body);
  return body;
}

/// A place of the drawing in a body's frame.
Point inBody(const BodyNumbers* body, Point at) {
  return body ? rotated({at.x - body->at.x, at.y - body->at.y}, -body->angle) : at;
}

/// The resistance of the two bodies to what moves a joint: their inertias or masses, one behind the other.
double reducedMass(const JointSpec& spec, const BodyNumbers* parent, const BodyNumbers& child) {
  const bool turns = spec.kind == JointSpec::Kind::Revolute;
  const auto inverse = [&](const BodyNumbers* body) {
    if (!body || body->still || (turns && !body->rotates)) return 0.0;
    return 1.0 / (turns ? body->inertiaAtOrigin : body->mass);
  };
  const double sum = inverse(parent) + inverse(&child);
  return sum > 0.0 ? 1.0 / sum : 1.0;
}

JointNumbers jointOf(const JointSpec& spec, const RobotNumbers& numbers, CheckedNumbers& number) {
  using Joins = JointSpec::Kind;
  const std::string where = fmt::format("[joint.{}]", spec.name);
  const BodyNumbers* parent = spec.parent < 0 ? nullptr : &numbers.bodies[static_cast<std::size_t>(spec.parent)];
  const BodyNumbers& child = numbers.bodies[static_cast<std::size_t>(spec.child)];
  JointNumbers joint;
  const Point at = number.at(spec.at, where, "at");
  const Point end = spec.kind == Joins::Distance ? number.at(spec.to, where, "to") : at;
  joint.atParent = inBody(parent, at), joint.atChild = inBody(&child, end);
  joint.turned = child.angle - (parent ? parent->angle : 0.0);
  joint.length = length({end.x - at.x, end.y - at.y});
  const double shortest = 0.005 / numbers.scale;
  if (spec.kind == Joins::Distance && joint.length < shortest)
    number.complain(spec.place, fmt::format("{}: its ends are {} m apart; at least {} m are needed.", where,
                                            joint.length, shortest));
  const Point axis = number.at(spec.axis, where, "axis");
  if (length(axis) < 1e-6) number.complain(spec.place, where + ": its axis has no direction.");
  joint.axis = rotated({axis.x / length(axis), axis.y / length(axis)}, parent ? -parent->angle : 0.0);

  const auto optional = [&](const std::optional<Formula>& formula, const char* what) {
    return formula ? number(*formula, where, what, 0, kMost) : 0.0;
  };
  joint.damping = optional(spec.damping, "damping");
  joint.armature = optional(spec.armature, "armature");
  joint.stiffness = optional(spec.stiffness, "stiffness");
  joint.friction = number(spec.friction, where, "friction", 0, kMost);
  joint.rest = number(spec.rest, where, "rest", -1e4, 1e4);
  joint.soft = spec.soft || spec.damping || spec.armature || spec.stiffness || spec.stop;
  if (spec.limits) {
    const double low = number((*spec.limits)[0], where, "limits", -1e4, 1e4);
    const double high = number((*spec.limits)[1], where, "limits", -1e4, 1e4);
    if (low > high)
      number.complain((*spec.limits)[0].at,
                      fmt::format("{}: limits: the lowest, {}, is above the highest, {}.", where, low, high));
    joint.limits = {std::min(low, high), std::max(low, high)};
    // A soft joint stops at limits that are as stiff as a substep can bear.
    const double h = numbers.stepTime / numbers.substeps, inertia = reducedMass(spec, parent, child);
    joint.stopStiffness = spec.stop ? number((*spec.stop)[0], where, "stop", 0, kMost) : 0.04 * inertia / (h * h);
    joint.stopDamping = spec.stop ? number((*spec.stop)[1], where, "stop", 0, kMost) : 0.4 * inertia / h;
  }
  return joint;
}

ActuatorNumbers actuatorOf(const ActuatorSpec& spec, CheckedNumbers& number) {
  const std::string where = fmt::format("[actuator.{}]", spec.name);
  ActuatorNumbers actuator;
  actuator.stiffness = number(spec.stiffness, where, "stiffness", 0, kMost);
  actuator.damping = number(spec.damping, where, "damping", 0, kMost);
  if (spec.kind == ActuatorSpec::Kind::DcMotor) {
    actuator.resistance = number(spec.resistance, where, "resistance", 1e-6, 1e6, "Ω");
    const double efficiency = number(spec.efficiency, where, "efficiency", 0, 1);
    actuator.emf = number(spec.torqueConstant, where, "torque_constant", 0, 1e6, "N m/A") *
                   number(spec.gear, where, "gear", 1e-6, 1e6);
    actuator.perVolt = efficiency * actuator.emf / actuator.resistance;
    actuator.damping = efficiency * actuator.emf * actuator.emf / actuator.resistance;
  }
  actuator.direction = number.at(spec.direction, where, "direction");
  for (const Formula& level : spec.levels) static_cast<void>(number(level, where, "levels", -kMost, kMost, spec.unit));
  return actuator;
}

/// Heights of steps or bumps: uniform from 0 to `height`, from the ground's own seed.
std::vector<Point> roughGround(const GroundSpec& spec, CheckedNumbers& number) {
  const std::string where = "[ground]";
  const double step = number(spec.length, where, "length", 1e-3, 1e4, "m");
  const double height = number(spec.height, where, "height", 0, 100, "m");
  const double from = number.at(spec.from, where, "from"), to = number.at(spec.to, where, "to");
  const auto seed = static_cast<std::uint64_t>(number(spec.seed, where, "seed", 0, 1e9));
  if (!(from < to)) number.complain(spec.place, "[ground]: from must lie left of to.");
  const double count = (to - from) / step;
  if (!(count >= 1 && count <= 1999)) {
    number.complain(spec.place,
                    fmt::format("[ground]: from, to and length make {:.0f} pieces; allowed is 1 … 1,999.", count));
    return {};
  }
  constexpr double kEnd = 500;  // [m]
  std::vector<Point> line = {{std::min(-kEnd, from - 1), 0}, {from, 0}};
  Random random(seed);
  double last = 0.0;
  for (int i = 1; i <= static_cast<int>(count); ++i) {
    const double x = from + i * step, y = random.uniform(0.0, height);
    if (spec.kind == GroundSpec::Kind::Steps) line.push_back({x - 0.001 * step, last});
    line.push_back({x, y});
    last = y;
  }
  line.push_back({to + step, 0});
  line.push_back({std::max(kEnd, to + step + 1), 0});
  return line;
}

void laidGround(const GroundSpec& spec, RobotNumbers& numbers, CheckedNumbers& number) {
  numbers.hasGround = spec.kind != GroundSpec::Kind::None;
  numbers.groundFriction = number(spec.friction, "[ground]", "friction", 0, 1000);
  if (spec.kind == GroundSpec::Kind::Steps || spec.kind == GroundSpec::Kind::Bumps)
    numbers.ground = roughGround(spec, number);
  for (const FormulaPair& point : spec.points) numbers.ground.push_back(number.at(point, "[ground]", "points"));
  for (std::size_t i = 1; i < numbers.ground.size(); ++i)
    if (numbers.ground[i].x - numbers.ground[i - 1].x < 1e-6)
      return number.complain(spec.place, "[ground]: its points go from left to right, each right of the last.");
}

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
