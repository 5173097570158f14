// SPDX-License-Identifier: GPL-3.0-or-later
// How LEO looks: torso and arm, the near leg in ink, the far leg quiet, feet that touch the floor marked.
#include <cmath>

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

struct Leg {
  Point hip, knee, ankle, heel, toe;
};

Leg legOf(std::span<const double> pose, int leg) {
  const auto angle = [&](int body) { return pose[2 + static_cast<std::size_t>(body + leg)]; };
  Leg l;
  l.hip = {pose[0], pose[1]};
  l.knee = from(l.hip, minus(kKnee.inParent, kHip.inChild), angle(kLeftThigh));
  l.ankle = from(l.knee, minus(kAnkle.inParent, kKnee.inChild), angle(kLeftShank));
  const Vec down{0.0, -kHeel.radius};
  l.heel = from(l.ankle, minus(kHeel.centre, kAnkle.inChild), angle(kLeftFoot));
  l.toe = from(l.ankle, minus(kToe.centre, kAnkle.inChild), angle(kLeftFoot));
  l.heel.y += down.y, l.toe.y += down.y;
  return l;
}

void drawLeg(const Leg& l, bool near, bool onFloor, Scene& scene) {
  const Ink ink = near ? Ink::Body : Ink::Outline;
  const double width = near ? 8 : 7;
  scene.shapes.push_back(Polyline{{l.hip, l.knee}, ink, width});
  scene.shapes.push_back(Polyline{{l.knee, l.ankle}, ink, width - 1});
  scene.shapes.push_back(Polygon{.points = {l.ankle, l.heel, l.toe}, .fill = Fill::Panel, .ink = ink, .width = 2});
  for (const Point& joint : {l.knee, l.ankle}) scene.shapes.push_back(Disc{joint, 0.009, Fill::Panel, ink, 2});
  if (onFloor) scene.shapes.push_back(Polyline{{{l.heel.x, 0.0}, {l.toe.x, 0.0}}, Ink::Solid, 4});
}

}  // namespace

void Leo::draw(std::span<const double> pose, Scene& scene) const {
  const Point hip{pose[0], pose[1]};
  const double torso = pose[2 + kTorso];
  scene.clear();
  scene.focus = {hip.x, 0};
  scene.height = 0.62;
  scene.width = 0.9;
  scene.tip = hip;
  drawLeg(legOf(pose, 1), false, pose[14] > 0.5, scene);

  const auto onTorso = [&](Vec v) { return from(hip, minus(v, kHip.inParent), torso); };
  constexpr double kHalf = 0.045, kTop = 0.125, kBottom = -0.12;  // its outline [m]
  scene.shapes.push_back(Polygon{.points = {onTorso({-kHalf, kBottom}), onTorso({kHalf, kBottom}),
                                            onTorso({kHalf, kTop}), onTorso({-kHalf, kTop})}});
  const Vec shoulder{-0.00543, 0.091275};
  constexpr double kArm = 0.15, kArmAngle = 15.0 * 3.14159265358979 / 180.0;  // welded on
  const Point from0 = onTorso(shoulder);
  const Point hand = onTorso({shoulder.x + kArm * std::sin(kArmAngle), shoulder.y - kArm * std::cos(kArmAngle)});
  scene.shapes.push_back(Polyline{{from0, hand}, Ink::Outline, 4});
  drawLeg(legOf(pose, 0), true, pose[13] > 0.5, scene);
  scene.shapes.push_back(Disc{hip, 0.014, Fill::Panel, Ink::Solid, 2});
}

std::vector<ReadOut> Leo::readOuts(std::span<const double> pose) const {
  return {{"x", "m", pose[0]}, {"U_h", "V", pose[9], 1}, {"U_H", "V", pose[10], 1}, {"U_K", "V", pose[11], 1}};
}

}  // namespace surefoot
