// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text/text.h"
#include "physics/robot/robot.h"
#include "physics/robot/world/masses.h"

namespace surefoot {

namespace {

class Drawing {
 public:
  Drawing(const Robot& robot, std::span<const double> pose, Scene& scene)
      : spec_(robot.spec()),
        numbers_(robot.numbers()),
        pose_(pose),
        scene_(scene) {}

  void all() {
    for (std::size_t b = 0; b < spec_.bodies.size(); ++b) body(b);
    for (const PictureLineSpec& line : spec_.picture.lines)
      scene_.shapes.push_back(Polyline{{point(line.from), point(line.to)}, line.ink, line.width, line.dashed});
    joints();
    arrows();
    for (const PictureLabelSpec& label : spec_.picture.labels)
      scene_.shapes.push_back(Label{.at = point(label.at), .text = label.text, .halo = true});
  }
  void ground(double around) {
    if (numbers_.ground.empty()) return;
    Polyline line{{}, Ink::Outline, 1.5, false};
    for (std::size_t i = 0; i < numbers_.ground.size(); ++i) {
      const Point p = numbers_.ground[i];
      const bool near = std::abs(p.x - scene_.focus.x) < around;
      const bool before = i + 1 < numbers_.ground.size() && numbers_.ground[i + 1].x > scene_.focus.x - around;
      const bool after = i > 0 && numbers_.ground[i - 1].x < scene_.focus.x + around;
      if (near || (p.x < scene_.focus.x ? before : after)) line.points.push_back({p.x, p.y});
    }
    if (line.points.size() > 1) scene_.shapes.push_back(std::move(line));
  }
  Point point(int index) const {
    const PointSpec& spec = spec_.points[static_cast<std::size_t>(index)];
    return inWorld(static_cast<std::size_t>(spec.body), numbers_.points[static_cast<std::size_t>(index)]);
  }

 private:
  BodyPlacement placement(std::size_t b) const {
    return {.at = {pose_[3 * b], pose_[3 * b + 1]}, .angle = pose_[3 * b + 2]};
  }
  Point inWorld(std::size_t b, Point local) const {
    const Point p = placeOf(placement(b), local);
    return {p.x, p.y};
  }
  void body(std::size_t b) {
    for (std::size_t i = 0; i < spec_.bodies[b].shapes.size(); ++i) {
      const ShapeSpec& look = spec_.bodies[b].shapes[i];
      const ShapeNumbers& shape = numbers_.bodies[b].shapes[i];
      if (!look.drawn) continue;
      if (shape.kind == ShapeSpec::Kind::Circle) {
        const Point centre = inWorld(b, shape.at);
        scene_.shapes.push_back(Disc{centre, shape.radius, look.fill, look.ink, look.width});
        const double turn = placement(b).angle;  // a spoke, to see it turn
        scene_.shapes.push_back(
            Polyline{{centre, {centre.x + shape.radius * std::cos(turn), centre.y + shape.radius * std::sin(turn)}},
                     Ink::Hairline,
                     1});
        continue;
      }
      Polygon polygon{{}, look.fill, look.ink, look.width};
      if (shape.kind == ShapeSpec::Kind::Rod)
        polygon.points = rodOutline(b, shape);
      else
        for (const Point corner : cornersOf(shape)) polygon.points.push_back(inWorld(b, corner));
      scene_.shapes.push_back(std::move(polygon));
    }
  }
  std::vector<Point> rodOutline(std::size_t b, const ShapeNumbers& rod) const {
    constexpr int kPieces = 6;
    const double way = std::atan2(rod.to.y - rod.at.y, rod.to.x - rod.at.x);
    std::vector<Point> points;
    for (const auto& [end, from] : {std::pair{rod.to, way - 0.5 * kPi}, std::pair{rod.at, way + 0.5 * kPi}})
      for (int i = 0; i <= kPieces; ++i) {
        const double a = from + kPi * i / kPieces;
        points.push_back(inWorld(b, {end.x + rod.radius * std::cos(a), end.y + rod.radius * std::sin(a)}));
      }
    return points;
  }
  void joints() {
    for (std::size_t j = 0; j < spec_.joints.size(); ++j) {
      const JointSpec& joint = spec_.joints[j];
      if (!joint.drawn || (joint.kind != JointSpec::Kind::Revolute && joint.kind != JointSpec::Kind::Wheel)) continue;
      const Point at = inWorld(static_cast<std::size_t>(joint.child), numbers_.joints[j].atChild);
      scene_.shapes.push_back(Disc{at, 0.008 * scene_.height, Fill::Panel, Ink::Solid, 1.5});
    }
  }
  void arrows() {
    const std::size_t first = 3 * spec_.bodies.size();
    for (std::size_t a = 0; a < spec_.actuators.size(); ++a) {
      const ActuatorSpec& actuator = spec_.actuators[a];
      const double u = pose_[first + a];
      if (actuator.arrow < 0 || u == 0.0 || most(a) == 0.0) continue;
      scene_.shapes.push_back(Arrow{point(actuator.arrow), 0.25 * scene_.height * actuator.arrowScale * u / most(a),
                                    fmt::format("{} {}", fixedText(u, 2), actuator.unit)});
    }
  }
  double most(std::size_t a) const {
    double largest = 0.0;
    for (const Formula& level : spec_.actuators[a].levels) {
      const auto in = level.expression.instructions();
      if (in.size() == 1 && in[0].operation == Operation::Constant) largest = std::max(largest, std::abs(in[0].number));
    }
    return largest > 0.0 ? largest : std::abs(pose_[3 * spec_.bodies.size() + a]);
  }

  static constexpr double kPi = 3.14159265358979323846;
  const RobotSpec& spec_;
  const RobotNumbers& numbers_;
  std::span<const double> pose_;
  Scene& scene_;
};

}  // namespace

void Robot::draw(std::span<const double> pose, Scene& scene) const {
  scene.clear();
  Drawing drawing(*this, pose, scene);
  const PictureSpec& picture = spec().picture;
  scene.height = picture.height ? (*picture.height)(values_.row()) : 1.0;
  scene.width = picture.width ? (*picture.width)(values_.row()) : 0.0;
  scene.metres = picture.metres;
  if (picture.follow >= 0) scene.focus = {drawing.point(picture.follow).x, 0.0};
  if (picture.tip >= 0) scene.tip = drawing.point(picture.tip);
  drawing.ground(2.0 * std::max(scene.width, 2.0 * scene.height));
  drawing.all();
}

std::vector<ReadOut> Robot::readOuts(std::span<const double> pose) const {
  std::vector<ReadOut> all;
  const std::size_t first = 3 * spec().bodies.size() + spec().actuators.size();
  for (std::size_t s = 0; s < task().state.size(); ++s)
    all.push_back({task().state[s].symbol, task().state[s].unit, pose[first + s]});
  for (const std::size_t a : values_.driven()) {
    const ActuatorSpec& actuator = spec().actuators[a];
    all.push_back({actuator.symbol.empty() ? actuator.title : actuator.symbol, actuator.unit,
                   pose[3 * spec().bodies.size() + a]});
  }
  return all;
}

}  // namespace surefoot
