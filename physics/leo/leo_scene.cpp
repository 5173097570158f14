// SPDX-License-Identifier: GPL-3.0-or-later
// How LEO looks: torso and arm, the near leg in ink, the far leg quiet, its centre of mass, the voltages as arcs round
// their joints, feet that touch the floor marked below it.
#include <cmath>
#include <numbers>

#include "core/text/text.h"
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

/// The outline of the torso in its own frame [m].
constexpr Vec kTrunk[] = {{-0.050, -0.1257}, {0.051, -0.1257},  {0.054, 0.059},
                          {0.036, 0.1143},   {-0.0345, 0.1143}, {-0.0567, 0.059}};

struct Leg {
  Point hip, knee, ankle, heel, toe;
  double footAngle;
};

Leg legOf(const Anatomy& a, std::span<const double> pose, int leg) {
  const auto angle = [&](int body) { return pose[2 + static_cast<std::size_t>(body + leg)]; };
  Leg l{};
  l.hip = {pose[0], pose[1]};
  l.knee = from(l.hip, minus(a.knee.inParent, a.hip.inChild), angle(kLeftThigh));
  l.ankle = from(l.knee, minus(a.ankle.inParent, a.knee.inChild), angle(kLeftShank));
  l.heel = from(l.ankle, minus(a.heel.centre, a.ankle.inChild), angle(kLeftFoot));
  l.footAngle = angle(kLeftFoot);
  l.toe = from(l.ankle, minus(a.toe.centre, a.ankle.inChild), angle(kLeftFoot));
  l.heel.y -= a.heel.radius, l.toe.y -= a.toe.radius;
  return l;
}

/// A link between two joints; the radii of its round ends give its width.
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

/// Heel, sole, toe and instep, in the frame of the foot, from the ankle [m].
constexpr Vec kFoot[] = {{-0.033, -0.0486}, {0.053, -0.0486},  {0.053, -0.038},
                         {0.0165, -0.012},  {-0.0125, -0.012}, {-0.036, -0.038}};

void drawLeg(const Leg& l, bool near, Scene& scene) {
  const Ink ink = near ? Ink::Body : Ink::Far;
  Polygon foot{.points = {}, .fill = near ? Fill::Solid : Fill::Panel, .ink = ink, .width = 2};
  for (const Vec& v : kFoot) foot.points.push_back(from(l.ankle, v, l.footAngle));
  scene.shapes.push_back(std::move(foot));
  scene.shapes.push_back(link(l.hip, l.knee, 0.022, 0.018, ink));
  scene.shapes.push_back(link(l.knee, l.ankle, 0.018, 0.0145, ink));
  scene.shapes.push_back(Disc{l.knee, 0.010, Fill::Panel, ink, 2});
  scene.shapes.push_back(Disc{l.ankle, 0.0075, Fill::Panel, ink, 2});
}

/// Below the floor: where heel and toe touch it, and which leg stands.
void drawStance(const Leg& l, bool stands, bool near, Scene& scene) {
  for (const Point& p : {l.heel, l.toe})
    if (p.y < 0.004)
      scene.shapes.push_back(Polygon{
          .points = {{p.x, -0.003}, {p.x - 0.008, -0.015}, {p.x + 0.008, -0.015}}, .fill = Fill::Solid, .width = 0});
  if (stands)
    scene.shapes.push_back(
        Label{{(l.heel.x + l.toe.x) / 2, 0}, near ? "stance, near leg" : "stance, far leg", 0, 38, 0, Ink::Quiet});
}

/// The scale of the torso's lean, and the lean that counts as a fall.
void drawProtractor(Point hip, double mostLean, Scene& scene) {
  constexpr double kRadius = 0.262;
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

/// A voltage as an arc round its joint, the longer, the higher, counter-clockwise where it is positive; its number at
/// `side` of the joint, `above` it [m].
struct VoltageArc {
  double volts, most, radius, side, above;
  bool near;
};

void drawVoltage(Point joint, const VoltageArc& v, Scene& scene) {
  const Ink ink = v.near ? Ink::Solid : Ink::Far;
  const double middle = -v.side * std::numbers::pi / 2, turn = 2.3 * v.volts / v.most;
  if (std::abs(turn) >= 0.05) {
    const double begin = middle - turn / 2, end = middle + turn / 2;
    scene.shapes.push_back(arc(joint, v.radius, begin, end, ink, 3));
    const double head = 0.013, tip = end + std::copysign(1.3 * head / v.radius, turn);
    scene.shapes.push_back(Polygon{.points = {polar(joint, v.radius, tip), polar(joint, v.radius - head / 2, end),
                                              polar(joint, v.radius + head / 2, end)},
                                   .fill = v.near ? Fill::Solid : Fill::Far,
                                   .ink = ink,
                                   .width = 1});
  }
  scene.shapes.push_back(Label{{joint.x + v.side * (v.radius + 0.018), joint.y + v.above},
                               fixedText(v.volts, 1) + " V",
                               0,
                               0,
                               static_cast<int>(v.side),
                               v.near ? Ink::Body : Ink::Quiet,
                               true});
}

/// The centre of mass: a disc in quarters.
void drawCentre(Point centre, Scene& scene) {
  constexpr double kRadius = 0.0115;
  scene.shapes.push_back(Disc{centre, kRadius, Fill::Panel, Ink::Solid, 1.5});
  for (const double begin : {0.0, std::numbers::pi}) {
    Polygon quarter{.points = {centre}, .fill = Fill::Solid, .ink = Ink::Solid, .width = 0};
    for (const Point& p : arc(centre, kRadius, begin, begin + std::numbers::pi / 2, Ink::Solid, 1).points)
      quarter.points.push_back(p);
    scene.shapes.push_back(std::move(quarter));
  }
}

}  // namespace

void Leo::draw(std::span<const double> pose, Scene& scene) const {
  const Point hip{pose[0], pose[1]};
  const double torso = pose[2 + kTorso];
  const bool nearStands = pose[12] < 0.5;
  scene.clear();
  scene.focus = {hip.x, 0};
  scene.height = 0.535;
  scene.width = 0.75;
  scene.tip = hip;
  drawProtractor(hip, settings_.mostTorso, scene);
  const Leg near = legOf(settings_.anatomy, pose, 0), far = legOf(settings_.anatomy, pose, 1);
  drawLeg(far, false, scene);

  const auto onTorso = [&](Vec v) { return from(hip, minus(v, settings_.anatomy.hip.inParent), torso); };
  Polygon trunk{.points = {}};
  for (const Vec& v : kTrunk) trunk.points.push_back(onTorso(v));
  scene.shapes.push_back(std::move(trunk));
  const Vec shoulder{-0.00543, 0.091275};
  constexpr double kArm = 0.15, kArmAngle = 15.0 * std::numbers::pi / 180.0;  // welded on
  const Point upper = onTorso(shoulder);
  const Point hand = onTorso({shoulder.x + kArm * std::sin(kArmAngle), shoulder.y - kArm * std::cos(kArmAngle)});
  drawCentre(onTorso({settings_.anatomy.torso.centre.x, settings_.anatomy.torso.centre.y}), scene);
  scene.shapes.push_back(link(upper, hand, 0.0125, 0.0105, Ink::Solid));
  scene.shapes.push_back(Disc{upper, 0.008, Fill::Panel, Ink::Solid, 2});
  drawLeg(near, true, scene);
  scene.shapes.push_back(Disc{hip, 0.013, Fill::Panel, Ink::Solid, 2});
  if (pose[13] > 0.5) drawStance(near, nearStands, true, scene);
  if (pose[14] > 0.5) drawStance(far, !nearStands, false, scene);

  // Numbers stand where no leg comes: the hips' numbers behind and in front, the knee's on the side without a leg.
  const Leg &standing = nearStands ? near : far, &swinging = nearStands ? far : near;
  const double away = swinging.knee.x < standing.knee.x ? -1 : 1, most = settings_.voltage;
  drawVoltage(hip, {pose[9], most, 0.053, -1, 0.022, nearStands}, scene);
  drawVoltage(hip, {pose[10], most, 0.066, 1, 0.022, !nearStands}, scene);
  drawVoltage(swinging.knee, {pose[11], most, 0.041, away, 0, !nearStands}, scene);
}

std::vector<ReadOut> Leo::readOuts(std::span<const double> pose) const {
  return {
      {"torso", "rad", pose[2 + kTorso]}, {"speed", "m/s", pose[16]}, {"steps", "", pose[15], 0}, {"x", "m", pose[0]}};
}

}  // namespace surefoot
