// SPDX-License-Identifier: GPL-3.0-or-later
// How LEO looks: torso and arm, the near leg in ink, the far leg quiet, its centre of mass, the voltages as arcs round
// their joints, feet that touch the floor marked below it.
#include <cmath>
#include <numbers>

#include "core/text.h"
#include "physics/leo/leo.h"

namespace surefoot {

using namespace leo;

namespace {

Point from(Point origin, Vec v, double angle) {
  return {origin.x + v.x * std::cos(angle) - v.y * std::sin(angle),
          origin.y + v.x * std::sin(angle) + v.y * std::cos(angle)};
}

Vec minus(Vec a, Vec b) {
  return {a.x - b.x, a.y - b.y};
}

/// The point at a distance, `angle` from upright, counter-clockwise.
Point polar(Point centre, double radius, double angle) {
  return {centre.x - radius * std::sin(angle), centre.y + radius * std::cos(angle)};
}

Polyline arc(Point centre, double radius, double begin, double end, Ink ink, double width) {
  Polyline line{.points = {}, .ink = ink, .width = width};
  constexpr int kPieces = 32;
  for (int i = 0; i <= kPieces; ++i) line.points.push_back(polar(centre, radius, begin + (end - begin) * i / kPieces));
  return line;
}

struct Leg {
  Point hip, knee, ankle, heel, toe;
};

Leg legOf(const Anatomy& a, std::span<const double> pose, int leg) {
  const auto angle = [&](int body) { return pose[2 + static_cast<std::size_t>(body + leg)]; };
  Leg l;
  l.hip = {pose[0], pose[1]};
  l.knee = from(l.hip, minus(a.knee.inParent, a.hip.inChild), angle(kLeftThigh));
  l.ankle = from(l.knee, minus(a.ankle.inParent, a.knee.inChild), angle(kLeftShank));
  l.heel = from(l.ankle, minus(a.heel.centre, a.ankle.inChild), angle(kLeftFoot));
  l.toe = from(l.ankle, minus(a.toe.centre, a.ankle.inChild), angle(kLeftFoot));
  l.heel.y -= a.heel.radius, l.toe.y -= a.toe.radius;
  return l;
}

/// A link between two joints, as wide as its ends are round.
Polygon link(Point a, Point b, double radiusA, double radiusB, Ink ink) {
  Polygon shape{.points = {}, .fill = Fill::Panel, .ink = ink, .width = 2};
  const double along = std::atan2(b.y - a.y, b.x - a.x);
  constexpr int kPieces = 10;
  const auto round = [&](Point centre, double radius, double begin) {
    for (int i = 0; i <= kPieces; ++i) {
      const double at = begin + std::numbers::pi * i / kPieces;
      shape.points.push_back({centre.x + radius * std::cos(at), centre.y + radius * std::sin(at)});
    }
  };
  round(a, radiusA, along + std::numbers::pi / 2);
  round(b, radiusB, along - std::numbers::pi / 2);
  return shape;
}

void drawLeg(const Leg& l, bool near, bool onFloor, Scene& scene) {
  const Ink ink = near ? Ink::Body : Ink::Outline;
  const Point top{l.ankle.x + 0.25 * (l.heel.x - l.ankle.x), l.ankle.y + 0.35 * (l.heel.y - l.ankle.y)};
  scene.shapes.push_back(Polygon{
      .points =
          {l.heel, l.toe, {l.toe.x + 0.1 * (l.ankle.x - l.toe.x), l.toe.y + 0.3 * (l.ankle.y - l.toe.y)}, l.ankle, top},
      .fill = near ? Fill::Solid : Fill::Panel,
      .ink = ink,
      .width = 2});
  scene.shapes.push_back(link(l.hip, l.knee, 0.014, 0.011, ink));
  scene.shapes.push_back(link(l.knee, l.ankle, 0.010, 0.008, ink));
  scene.shapes.push_back(Disc{l.knee, 0.0075, Fill::Panel, ink, 2});
  scene.shapes.push_back(Disc{l.ankle, 0.005, Fill::Panel, ink, 2});
  if (!onFloor) return;
  for (const Point& p : {l.heel, l.toe})
    if (p.y < 0.004)
      scene.shapes.push_back(Polygon{
          .points = {{p.x, -0.002}, {p.x - 0.005, -0.011}, {p.x + 0.005, -0.011}}, .fill = Fill::Solid, .width = 0});
}

/// Scale of the torso's lean, and where it counts as a fall.
void drawProtractor(Point hip, double mostLean, Scene& scene) {
  constexpr double kRadius = 0.285;
  for (const double side : {-1.0, 1.0}) {
    const double fall = side * mostLean;
    Polygon wedge{.points = {hip}, .fill = Fill::Fall, .ink = Ink::Fall, .width = 0};
    for (const Point& p : arc(hip, kRadius, fall, fall + side * 0.18, Ink::Fall, 1).points) wedge.points.push_back(p);
    scene.shapes.push_back(std::move(wedge));
    scene.shapes.push_back(Polyline{{polar(hip, 0.2 * kRadius, fall), polar(hip, kRadius, fall)}, Ink::Fall, 1.25});
    scene.shapes.push_back(Label{polar(hip, kRadius, fall), "fall " + fixedText(fall, 1) + " rad", -6 * side, -4,
                                 static_cast<int>(-side), Ink::Fall});
  }
  scene.shapes.push_back(arc(hip, kRadius, -mostLean, mostLean, Ink::Outline, 1));
  for (const double lean : {-0.5, 0.0, 0.5}) {
    scene.shapes.push_back(Polyline{{polar(hip, kRadius, lean), polar(hip, 0.97 * kRadius, lean)}, Ink::Outline, 1});
    scene.shapes.push_back(Label{polar(hip, kRadius, lean), lean == 0 ? "0 rad" : fixedText(lean, 1),
                                 lean == 0  ? 0.0
                                 : lean > 0 ? -6.0
                                            : 6.0,
                                 -11, 0, Ink::Quiet});
  }
}

/// A voltage as an arc round its joint: the longer, the higher, counter-clockwise where it is positive.
void drawVoltage(Point joint, double volts, double most, double side, bool near, Scene& scene) {
  const Ink ink = near ? Ink::Solid : Ink::Outline;
  const double begin = -side * std::numbers::pi / 2, turn = 1.4 * volts / most;
  constexpr double kRadius = 0.034;
  scene.shapes.push_back(Label{{joint.x + side * 1.35 * kRadius, joint.y},
                               fixedText(volts, 1) + " V",
                               4 * side,
                               0,
                               static_cast<int>(side),
                               near ? Ink::Solid : Ink::Quiet,
                               true});
  if (std::abs(turn) < 0.05) return;
  scene.shapes.push_back(arc(joint, kRadius, begin - turn / 2, begin + turn / 2, ink, 2.5));
  const double end = begin + turn / 2, tip = end + (turn > 0 ? 0.22 : -0.22);
  scene.shapes.push_back(Polygon{
      .points = {polar(joint, kRadius, tip), polar(joint, 0.8 * kRadius, end), polar(joint, 1.2 * kRadius, end)},
      .fill = near ? Fill::Solid : Fill::Panel,
      .ink = ink,
      .width = 1});
}

}  // namespace

void Leo::draw(std::span<const double> pose, Scene& scene) const {
  const Point hip{pose[0], pose[1]};
  const double torso = pose[2 + kTorso];
  const int stance = pose[12] > 0.5 ? 1 : 0;
  scene.clear();
  scene.focus = {hip.x, 0};
  scene.height = 0.60;
  scene.width = 0.75;
  scene.tip = hip;
  drawProtractor(hip, settings_.mostTorso, scene);
  const Leg near = legOf(settings_.anatomy, pose, 0), far = legOf(settings_.anatomy, pose, 1);
  drawLeg(far, false, pose[14] > 0.5, scene);

  const auto onTorso = [&](Vec v) { return from(hip, minus(v, settings_.anatomy.hip.inParent), torso); };
  scene.shapes.push_back(Polygon{.points = {onTorso({-0.032, -0.122}), onTorso({0.034, -0.122}), onTorso({0.048, 0.1}),
                                            onTorso({0.012, 0.125}), onTorso({-0.03, 0.112})}});
  const Vec shoulder{-0.00543, 0.091275};
  constexpr double kArm = 0.12, kArmAngle = 15.0 * std::numbers::pi / 180.0;  // welded on
  const Point upper = onTorso(shoulder);
  const Point hand = onTorso({shoulder.x + kArm * std::sin(kArmAngle), shoulder.y - kArm * std::cos(kArmAngle)});
  scene.shapes.push_back(link(upper, hand, 0.012, 0.008, Ink::Solid));
  scene.shapes.push_back(Disc{upper, 0.007, Fill::Panel, Ink::Solid, 2});
  const Point centre = onTorso({settings_.anatomy.torso.centre.x, settings_.anatomy.torso.centre.y});
  scene.shapes.push_back(Disc{centre, 0.008, Fill::Panel, Ink::Solid, 1.5});
  scene.shapes.push_back(Disc{centre, 0.003, Fill::Solid, Ink::Solid, 0});
  drawLeg(near, true, pose[13] > 0.5, scene);
  scene.shapes.push_back(Disc{hip, 0.0105, Fill::Panel, Ink::Solid, 2});

  const Leg& swinging = stance == 0 ? far : near;
  drawVoltage(hip, pose[9], settings_.voltage, -1, stance == 0, scene);
  drawVoltage(hip, pose[10], settings_.voltage, 1, stance == 1, scene);
  drawVoltage(swinging.knee, pose[11], settings_.voltage, 1, stance == 1, scene);
}

std::vector<ReadOut> Leo::readOuts(std::span<const double> pose) const {
  return {
      {"torso", "rad", pose[2 + kTorso]}, {"speed", "m/s", pose[16]}, {"steps", "", pose[15], 0}, {"x", "m", pose[0]}};
}

}  // namespace surefoot
