// SPDX-License-Identifier: GPL-3.0-or-later
// How the compass walker looks: the near leg in ink, the far leg quiet; it does not matter which one stands.
#include <algorithm>
#include <cmath>

#include "core/text/text.h"
#include "physics/compass/compass.h"

namespace surefoot {

namespace {

constexpr double kPerTorque = 0.12;  // length of an arrow [m per N m]

/// From the hip down the leg; the foot forward is positive.
Point along(Point hip, double length, double angle) {
  return {hip.x + length * std::sin(angle), hip.y - length * std::cos(angle)};
}

}  // namespace

void Compass::draw(std::span<const double> pose, Scene& scene) const {
  const double x = pose[0], stance = pose[1], swing = pose[3], torque = pose[5];
  const int stanceLeg = pose[6] > 0.5;
  const double toFoot = settings_.legLength - settings_.footRadius;
  const Point hip{x, toFoot * std::cos(stance) + settings_.footRadius};
  scene.clear();
  scene.focus = {x, 0};
  scene.height = 1.3 * settings_.legLength;
  scene.width = 2.4 * settings_.legLength;
  scene.tip = hip;
  const auto leg = [&](int number) {
    const bool stands = number == stanceLeg;
    const Point foot = along(hip, toFoot, stands ? stance : swing);
    const Ink ink = number == 0 ? Ink::Body : Ink::Far;
    scene.shapes.push_back(Polyline{{hip, foot}, ink, number == 0 ? 7.0 : 6.0});
    scene.shapes.push_back(Disc{foot, settings_.footRadius, Fill::Panel, number == 0 ? Ink::Solid : Ink::Far, 2});
    if (stands)  // where it meets the floor
      scene.shapes.push_back(Polyline{{{foot.x - 0.03, 0.0}, {foot.x + 0.03, 0.0}}, Ink::Solid, 4});
  };
  leg(1);
  leg(0);
  scene.shapes.push_back(Disc{hip, 0.035, Fill::Panel, Ink::Solid, 2});
  const double most = 0.5 * settings_.legLength, length = std::clamp(kPerTorque * torque, -most, most);
  if (torque != 0.0) scene.shapes.push_back(Arrow{{x, hip.y + 0.06}, length, fixedText(torque, 2) + " N m"});
}

std::vector<ReadOut> Compass::readOuts(std::span<const double> pose) const {
  return {{"θ", "rad", pose[1]}, {"φ", "rad", pose[3]}, {"x", "m", pose[0]}, {"T", "N m", pose[5]}};
}

}  // namespace surefoot
