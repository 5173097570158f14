// SPDX-License-Identifier: GPL-3.0-or-later
// What is measured of the moving robot.
#include <algorithm>
#include <cmath>

#include "physics/robot/world/robot_world.h"
#include "physics/robot/world/world_units.h"

namespace surefoot {

using namespace robot_units;

namespace {

using What = Probe::What;

bool isTouching(const b2Body& body, std::size_t shape) {
  for (const b2ContactEdge* edge = body.GetContactList(); edge; edge = edge->next) {
    b2Contact& contact = *edge->contact;
    if (!contact.IsTouching() || !contact.IsEnabled()) continue;
    if (shape == 0) return true;
    b2Fixture* own = contact.GetFixtureA()->GetBody() == &body ? contact.GetFixtureA() : contact.GetFixtureB();
    if (own->GetUserData().pointer == shape) return true;
  }
  return false;
}

/// The nearest thing of the ground on a ray.
class GroundRay : public b2RayCastCallback {
 public:
  explicit GroundRay(const b2Body& ground) : ground_(ground) {}
  float ReportFixture(b2Fixture* fixture, const b2Vec2&, const b2Vec2&, float fraction) override {
    if (fixture->GetBody() != &ground_) return -1.0f;
    nearest = std::min(nearest, fraction);
    return fraction;
  }
  float nearest = 1.0f;

 private:
  const b2Body& ground_;
};

}  // namespace

void RobotWorld::addProbes() {
  const auto& probes = robot_.names.probes();
  std::vector<std::size_t> firstShape;
  std::size_t shapes = 0;
  for (const BodySpec& body : robot_.bodies) firstShape.push_back(shapes), shapes += body.shapes.size();
  for (std::size_t i = 0; i < probes.size(); ++i) {
    ReadProbe read{probes[i], static_cast<std::size_t>(robot_.names.firstProbe()) + i, nullptr, b2Vec2_zero, false};
    const auto index = static_cast<std::size_t>(probes[i].index);
    if (probes[i].of == NameKind::Body) {
      read.body = bodies_[index];
      if (probes[i].shape >= 0)
        read.probe.shape = static_cast<int>(firstShape[index] + static_cast<std::size_t>(probes[i].shape));
    } else if (probes[i].of == NameKind::Point || probes[i].of == NameKind::Ray) {
      const auto point = probes[i].of == NameKind::Ray ? static_cast<std::size_t>(robot_.rays[index].point) : index;
      read.body = bodies_[static_cast<std::size_t>(robot_.points[point].body)];
      read.local = inside(numbers_.points[point]);
    }
    if (read.body) read.atCentre = read.local == read.body->GetLocalCenter();
    all_.push_back(read);
  }
  for (const Solid& solid : solids_) alsoInSubstep(*solid.expression);
  for (const ActuatorSpec& actuator : robot_.actuators)
    for (const auto* formula : {&actuator.effort, &actuator.limit})
      if (*formula) alsoInSubstep((*formula)->expression);
}

void RobotWorld::alsoInSubstep(const Expression& expression) {
  for (const int place : expression.variables()) {
    const int index = place - robot_.names.firstProbe();
    if (index < 0) continue;
    const ReadProbe& read = all_[static_cast<std::size_t>(index)];
    const auto same = [&](const ReadProbe& other) { return other.place == read.place; };
    if (std::none_of(inSubstep_.begin(), inSubstep_.end(), same)) inSubstep_.push_back(read);
  }
}

void RobotWorld::read(const std::vector<ReadProbe>& probes, std::span<double> values, std::span<const double> u) const {
  for (const ReadProbe& probe : probes) values[probe.place] = measured(probe, u);
}

double RobotWorld::measured(const ReadProbe& read, std::span<const double> u) const {
  const auto velocity = [&] {
    return read.atCentre ? read.body->GetLinearVelocity() : read.body->GetLinearVelocityFromLocalPoint(read.local);
  };
  const auto position = [&] {
    return read.probe.of == NameKind::Body ? read.body->GetPosition() : read.body->GetWorldPoint(read.local);
  };
  switch (read.probe.what) {
    case What::X:
      return full(position().x) / scale_;
    case What::Y:
      return full(position().y) / scale_;
    case What::Vx:
      return full(velocity().x) / scale_;
    case What::Vy:
      return full(velocity().y) / scale_;
    case What::Height:
      return full(position().y) / scale_ - numbers_.groundAt(full(position().x) / scale_);
    case What::Angle:
      return read.body ? full(read.body->GetAngle()) : jointPosition(read.probe.index);
    case What::Rate:
      return read.body ? full(read.body->GetAngularVelocity()) : jointRate(read.probe.index);
    case What::Touches:
      return isTouching(*read.body, static_cast<std::size_t>(read.probe.shape + 1)) ? 1.0 : 0.0;
    case What::Distance:
      return read.probe.of == NameKind::Ray ? rayDistance(read) : jointPosition(read.probe.index);
    case What::U:
      return u[static_cast<std::size_t>(read.probe.index)];
    case What::Effort:
      return efforts_[static_cast<std::size_t>(read.probe.index)];
    case What::Power:
      return power(read.probe.index, u[static_cast<std::size_t>(read.probe.index)]);
    case What::Sent:
      break;  // there is no program here
  }
  return 0.0;
}

double RobotWorld::jointPosition(int index) const {
  const auto j = static_cast<std::size_t>(index);
  const Joint& joint = joints_[j];
  if (joint.prismatic) return full(joint.prismatic->GetJointTranslation()) / scale_;
  if (robot_.joints[j].kind == JointSpec::Kind::Distance)
    return full((joint.joint->GetAnchorB() - joint.joint->GetAnchorA()).Length()) / scale_;
  return full(joint.child->GetAngle()) - full(joint.parent->GetAngle()) - numbers_.joints[j].turned;
}

double RobotWorld::jointRate(int index) const {
  const auto j = static_cast<std::size_t>(index);
  const Joint& joint = joints_[j];
  if (joint.prismatic) return full(joint.prismatic->GetJointSpeed()) / scale_;
  if (robot_.joints[j].kind == JointSpec::Kind::Distance) {
    const b2Vec2 a = joint.joint->GetAnchorA(), b = joint.joint->GetAnchorB();
    b2Vec2 along = b - a;
    along.Normalize();
    return full(b2Dot(along, joint.child->GetLinearVelocityFromWorldPoint(b) -
                                 joint.parent->GetLinearVelocityFromWorldPoint(a))) /
           scale_;
  }
  return full(joint.child->GetAngularVelocity()) - full(joint.parent->GetAngularVelocity());
}

bool RobotWorld::touches(int body) const {
  return isTouching(*bodies_[static_cast<std::size_t>(body)], 0);
}

double RobotWorld::rayDistance(const ReadProbe& read) const {
  const auto [angle, length] = numbers_.rays[static_cast<std::size_t>(read.probe.index)];
  const Point way = turned({scale_ * length, 0.0}, full(read.body->GetAngle()) + angle);
  const b2Vec2 from = read.body->GetWorldPoint(read.local);
  GroundRay ray(*ground_);
  world_.RayCast(&ray, from, from + b2Vec2(single(way.x), single(way.y)));
  return full(ray.nearest) * length;
}

double RobotWorld::power(int index, double u) const {
  const ActuatorSpec& spec = robot_.actuators[static_cast<std::size_t>(index)];
  const ActuatorNumbers& numbers = numbers_.actuators[static_cast<std::size_t>(index)];
  const double rate = spec.joint < 0 ? 0.0 : jointRate(spec.joint);
  if (spec.kind == ActuatorSpec::Kind::DcMotor) return u * (u - numbers.emf * rate) / numbers.resistance;
  return efforts_[static_cast<std::size_t>(index)] * rate;
}

BodyPlacement RobotWorld::placement(int index) const {
  const b2Body& body = *bodies_[static_cast<std::size_t>(index)];
  const b2Vec2 v = body.GetLinearVelocityFromLocalPoint(b2Vec2_zero);
  return {{full(body.GetPosition().x) / scale_, full(body.GetPosition().y) / scale_},
          full(body.GetAngle()),
          {full(v.x) / scale_, full(v.y) / scale_},
          full(body.GetAngularVelocity())};
}

double RobotWorld::jointSeparation() const {
  double most = 0.0;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    if (!joints_[j].prismatic && robot_.joints[j].kind != JointSpec::Kind::Distance &&
        robot_.joints[j].kind != JointSpec::Kind::Wheel)
      most = std::max(most, full((joints_[j].joint->GetAnchorA() - joints_[j].joint->GetAnchorB()).Length()));
  return most / scale_;
}

double RobotWorld::motion() const {
  double sum = 0.0;
  for (const b2Body* body : bodies_) {
    if (body->GetType() == b2_staticBody) continue;
    const double mass = full(body->GetMass()), rate = full(body->GetAngularVelocity());
    const double about = full(body->GetInertia()) - mass * full(body->GetLocalCenter().LengthSquared());
    sum += 0.5 * mass * full(body->GetLinearVelocity().LengthSquared()) + 0.5 * about * rate * rate;
  }
  return sum / (scale_ * scale_);
}

double RobotWorld::height() const {
  double sum = 0.0;
  for (const b2Body* body : bodies_) {
    if (body->GetType() == b2_staticBody) continue;
    const b2Vec2 p = body->GetWorldCenter();
    sum -= full(body->GetMass()) * (numbers_.gravity.x * full(p.x) + numbers_.gravity.y * full(p.y));
  }
  return sum / scale_;
}

}  // namespace surefoot
