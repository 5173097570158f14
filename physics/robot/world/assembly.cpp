// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/world/assembly.h"

#include <algorithm>
#include <cmath>

#include "core/basics/portable_math.h"
#include "physics/robot/world/masses.h"

namespace surefoot {

namespace {

constexpr std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

bool slides(const JointSpec& joint) {
  return joint.kind == JointSpec::Kind::Prismatic;
}

}  // namespace

Point turned(Point v, double angle) {
  if (angle == 0.0) return v;
  const double c = portableCos(angle), s = portableSin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

Point placeOf(const BodyPlacement& body, Point point) {
  const Point arm = turned(point, body.angle);
  return {body.at.x + arm.x, body.at.y + arm.y};
}

Point velocityOf(const BodyPlacement& body, Point point) {
  const Point arm = turned(point, body.angle);
  return {body.velocity.x - body.rate * arm.y, body.velocity.y + body.rate * arm.x};
}

Assembly::Assembly(const RobotSpec& robot, const RobotNumbers& numbers) : robot_(robot), numbers_(numbers) {
  const std::size_t bodies = robot.bodies.size();
  isFree_.assign(bodies, false);
  std::vector<bool> there(bodies, false), used(robot.joints.size(), false);
  const auto placed = [&](int body) { return body < 0 || there[at(body)]; };
  for (;;) {
    bool more = false;
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      const JointSpec& joint = robot.joints[j];
      if (used[j] || joint.kind == JointSpec::Kind::Distance || placed(joint.parent) == placed(joint.child)) continue;
      const bool backwards = placed(joint.child);
      const int body = backwards ? joint.parent : joint.child;
      links_.push_back({static_cast<int>(j), body, backwards});
      there[at(body)] = used[j] = more = true;
    }
    if (more) continue;
    const auto next = std::find(there.begin(), there.end(), false);
    if (next == there.end()) break;
    *next = true;
    const auto body = static_cast<int>(next - there.begin());
    isFree_[at(body)] = true;
    links_.push_back({-1, body, false});
  }
  for (std::size_t j = 0; j < robot.joints.size(); ++j)
    if (!used[j] && robot.joints[j].kind != JointSpec::Kind::Distance) closing_.push_back(static_cast<int>(j));
}

Coordinates Assembly::drawing() const {
  Coordinates c;
  c.joints.assign(numbers_.joints.size(), 0.0);
  c.jointRates.assign(numbers_.joints.size(), 0.0);
  c.angles.assign(numbers_.bodies.size(), std::nullopt);
  c.rates.assign(numbers_.bodies.size(), std::nullopt);
  for (const BodyNumbers& body : numbers_.bodies) c.free.push_back({.at = body.at, .angle = body.angle});
  return c;
}

void Assembly::hang(const Link& link, const Coordinates& c, std::vector<BodyPlacement>& bodies) const {
  const JointSpec& spec = robot_.joints[at(link.joint)];
  const JointNumbers& joint = numbers_.joints[at(link.joint)];
  const int before = link.backwards ? spec.child : spec.parent;
  const BodyPlacement from = before < 0 ? BodyPlacement{} : bodies[at(before)];
  const double sign = link.backwards ? -1.0 : 1.0;
  double q = c.joints[at(link.joint)], rate = c.jointRates[at(link.joint)];
  double turn = slides(spec) ? 0.0 : q, spin = slides(spec) ? 0.0 : rate;
  BodyPlacement& body = bodies[at(link.body)];
  body.angle = from.angle + sign * (joint.turned + turn);
  body.rate = from.rate + sign * spin;
  if (const auto angle = c.angles[at(link.body)]; angle && !slides(spec)) body.angle = *angle;
  if (const auto own = c.rates[at(link.body)]; own && !slides(spec)) body.rate = *own;

  const double parentAngle = link.backwards ? body.angle : from.angle;
  const double parentRate = link.backwards ? body.rate : from.rate;
  Point slide{}, sliding{};
  if (slides(spec)) {
    const Point axis = turned(joint.axis, parentAngle);
    slide = {axis.x * q, axis.y * q};
    sliding = {axis.x * rate - parentRate * slide.y, axis.y * rate + parentRate * slide.x};
  }
  const Point hold = placeOf(from, link.backwards ? joint.atChild : joint.atParent);
  const Point moves = velocityOf(from, link.backwards ? joint.atChild : joint.atParent);
  const Point arm = turned(link.backwards ? joint.atParent : joint.atChild, body.angle);
  body.at = {hold.x + sign * slide.x - arm.x, hold.y + sign * slide.y - arm.y};
  body.velocity = {moves.x + sign * sliding.x + body.rate * arm.y, moves.y + sign * sliding.y - body.rate * arm.x};
}

std::vector<BodyPlacement> Assembly::placed(const Coordinates& c) const {
  std::vector<BodyPlacement> bodies(numbers_.bodies.size());
  for (const Link& link : links_) {
    if (link.joint < 0)
      bodies[at(link.body)] = c.free[at(link.body)];
    else
      hang(link, c, bodies);
  }
  return bodies;
}

double Assembly::lowestGap(const std::vector<BodyPlacement>& bodies) const {
  double lowest = kInfinity;
  const auto look = [&](Point p, double radius) { lowest = std::min(lowest, p.y - radius - numbers_.groundAt(p.x)); };
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (const ShapeNumbers& shape : numbers_.bodies[b].shapes) {
      if (shape.meets == Meets::Nothing) continue;
      const bool round = shape.kind == ShapeSpec::Kind::Circle || shape.kind == ShapeSpec::Kind::Rod;
      if (round) look(placeOf(bodies[b], shape.at), shape.radius);
      if (shape.kind == ShapeSpec::Kind::Rod) look(placeOf(bodies[b], shape.to), shape.radius);
      if (round) continue;
      for (const Point corner : cornersOf(shape)) look(placeOf(bodies[b], corner), 0.0);
    }
  return lowest;
}

void Assembly::settle(std::vector<BodyPlacement>& bodies) const {
  // What is joined to the world stays where it is; with it everything does.
  const bool fixed =
      std::any_of(robot_.joints.begin(), robot_.joints.end(), [](const auto& j) { return j.parent < 0; });
  if (fixed) return;
  if (robot_.onGround)
    if (const double gap = lowestGap(bodies); gap < kInfinity)
      for (BodyPlacement& body : bodies) body.at.y -= gap;
  if (robot_.atRest < 0) return;
  const PointSpec& point = robot_.points[at(robot_.atRest)];
  const Point v = velocityOf(bodies[at(point.body)], numbers_.points[at(robot_.atRest)]);
  for (BodyPlacement& body : bodies) body.velocity.x -= v.x, body.velocity.y -= v.y;
}

std::vector<BodyPlacement> Assembly::settled(const Coordinates& coordinates) const {
  auto bodies = placed(coordinates);
  settle(bodies);
  return bodies;
}

std::vector<BodyPlacement> Assembly::start(std::span<const double> values, Random& random) const {
  using What = StartSpec::What;
  Coordinates c = drawing();
  for (const StartSpec& start : robot_.start) {
    const double value = start.value.expression.evaluate(values, &random);
    const std::size_t i = at(start.index);
    if (!start.ofBody) {
      (start.what == What::Rate ? c.jointRates : c.joints)[i] = value;
      continue;
    }
    BodyPlacement& body = c.free[i];
    if (start.what == What::Position) body.angle = value, c.angles[i] = value;
    if (start.what == What::Rate) body.rate = value, c.rates[i] = value;
    if (start.what == What::X) body.at.x = value;
    if (start.what == What::Y) body.at.y = value;
    if (start.what == What::Vx) body.velocity.x = value;
    if (start.what == What::Vy) body.velocity.y = value;
  }
  return settled(c);
}

double Assembly::gap(int joint, const std::vector<BodyPlacement>& bodies) const {
  const JointSpec& spec = robot_.joints[at(joint)];
  const BodyPlacement parent = spec.parent < 0 ? BodyPlacement{} : bodies[at(spec.parent)];
  const Point a = placeOf(parent, numbers_.joints[at(joint)].atParent);
  const Point b = placeOf(bodies[at(spec.child)], numbers_.joints[at(joint)].atChild);
  const Point apart{b.x - a.x, b.y - a.y};
  if (!slides(spec)) return std::sqrt(apart.x * apart.x + apart.y * apart.y);
  const Point axis = turned(numbers_.joints[at(joint)].axis, parent.angle);
  return std::abs(apart.x * axis.y - apart.y * axis.x);
}

}  // namespace surefoot
