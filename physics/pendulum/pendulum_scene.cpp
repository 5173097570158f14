// SPDX-License-Identifier: GPL-3.0-or-later
// How the pendulum looks: cart, wheel, pole and protractor as flat shapes in metres.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/text/text.h"
#include "physics/pendulum/pendulum.h"

namespace surefoot {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPerTorque = 0.042;  // length of an arrow [m per N m]
constexpr double kArrowAt = 2.02;     // where it begins, in wheel radii from the middle

/// The point at a distance from the hinge, `angle` from upright, clockwise.
Point polar(Point hinge, double radius, double angle) {
  return {hinge.x + radius * std::sin(angle), hinge.y + radius * std::cos(angle)};
}

Polyline arc(Point hinge, double radius, double from, double to, Ink ink) {
  Polyline line{.points = {}, .ink = ink, .width = 1.0};
  constexpr int kPieces = 48;
  for (int i = 0; i <= kPieces; ++i) line.points.push_back(polar(hinge, radius, from + (to - from) * i / kPieces));
  return line;
}

Polygon box(Point lowerLeft, Point upperRight) {
  return {.points = {lowerLeft, {upperRight.x, lowerLeft.y}, upperRight, {lowerLeft.x, upperRight.y}}};
}

/// The arrow of the strongest action [m].
double longestArrow(const PendulumSettings& s, const Task& task) {
  return std::min(kPerTorque * s.torqueScale * task.actions.back(), 2 * s.poleLength);
}

/// "0.2π", "0.45π".
std::string inPi(double angle) {
  const double tenths = angle / kPi * 10;
  return fixedText(angle / kPi, std::abs(tenths - std::round(tenths)) < 1e-6 ? 1 : 2) + "π";
}

/// Scale, fall wedges and the balanced mark.
void drawProtractor(const PendulumSettings& s, Point hinge, Scene& scene) {
  const double radius = 1.24 * s.poleLength;
  for (const double side : {-1.0, 1.0}) {
    const double fall = side * s.fallAngle;
    Polygon wedge{.points = {hinge}, .fill = Fill::Fall, .ink = Ink::Fall, .width = 0};
    for (const Point& p : arc(hinge, radius, fall, side * kPi / 2, Ink::Fall).points) wedge.points.push_back(p);
    scene.shapes.push_back(std::move(wedge));
    scene.shapes.push_back(Polyline{{polar(hinge, 0.3 * radius, fall), polar(hinge, radius, fall)}, Ink::Fall, 1.25});
    scene.shapes.push_back(
        Label{polar(hinge, radius, fall), "fall " + inPi(fall), 8 * side, 0, static_cast<int>(side), Ink::Fall});
  }
  scene.shapes.push_back(arc(hinge, radius, -s.fallAngle, s.fallAngle, Ink::Outline));
  for (int i = -4; i <= 4; ++i) {
    const double angle = 0.1 * kPi * i;
    if (i == 0 || std::abs(angle) > s.fallAngle - 0.02 * kPi) continue;
    scene.shapes.push_back(
        Polyline{{polar(hinge, radius, angle), polar(hinge, 0.97 * radius, angle)}, Ink::Outline, 1.0});
    const int side = i < 0 ? -1 : 1;
    if (i % 2 == 0)
      scene.shapes.push_back(Label{polar(hinge, radius, angle), inPi(angle), 6.0 * side, -6, side, Ink::Quiet});
  }
  scene.shapes.push_back(Polyline{{hinge, polar(hinge, radius, 0)}, Ink::Outline, 1.0, true});
  scene.shapes.push_back(Polyline{{polar(hinge, 0.97 * radius, 0), polar(hinge, 1.03 * radius, 0)}, Ink::Solid, 1.5});
  scene.shapes.push_back(Label{polar(hinge, radius, 0), "balanced", 0, -16, 0, Ink::Quiet});
}

void drawCart(const PendulumSettings& s, double x, Point hinge, Scene& scene) {
  const double r = s.wheelRadius;
  const auto at = [&](double dx, double y) { return Point{x + dx * r, y * r}; };
  for (const double side : {-1.0, 1.0}) {
    scene.shapes.push_back(
        box(at(side * 0.48 - (side < 0 ? 1.36 : 0), 0.7), at(side * 0.48 + (side > 0 ? 1.36 : 0), 1.32)));
    scene.shapes.push_back(Disc{at(side * 1.36, 0.35), 0.35 * r, Fill::Panel, Ink::Solid, 2});
    scene.shapes.push_back(Disc{at(side * 1.36, 0.35), 0.045 * r, Fill::Solid, Ink::Solid, 0});
  }
  scene.shapes.push_back(
      Polygon{.points = {at(-0.36, 1.93), at(0.36, 1.93), {hinge.x + 0.1 * r, hinge.y}, {hinge.x - 0.1 * r, hinge.y}}});
  const Point centre = at(0, 1);
  scene.shapes.push_back(Disc{centre, r, Fill::Panel, Ink::Solid, 2});
  scene.shapes.push_back(Disc{centre, 0.9 * r, Fill::None, Ink::Hairline, 1});
  for (int spoke = 2; spoke >= 0; --spoke) {  // the wheel has turned by x/R; one spoke is drawn stronger to see it turn
    const double turn = x / r + spoke * 2 * kPi / 3 - kPi / 2 + 0.2;
    scene.shapes.push_back(Polyline{{centre, polar(centre, 0.9 * r, turn)}, spoke == 0 ? Ink::Solid : Ink::Outline, 3});
  }
  scene.shapes.push_back(Disc{centre, 0.075 * r, Fill::Panel, Ink::Solid, 2});
}

}  // namespace

void Pendulum::draw(std::span<const double> pose, Scene& scene) const {
  const double x = pose[0], angle = pose[1], torque = pose[4];
  const double r = settings_.wheelRadius;
  const Point hinge{x, 2.31 * r};
  scene.clear();
  scene.focus = {x, 0};
  scene.height = hinge.y + 1.24 * settings_.poleLength;
  const double longest = longestArrow(settings_, task_);
  scene.width = std::max(3.6 * settings_.poleLength, 2 * (kArrowAt * r + longest + Arrow::kHead));
  scene.tip = polar(hinge, settings_.poleLength, angle);

  drawProtractor(settings_, hinge, scene);
  drawCart(settings_, x, hinge, scene);
  if (std::abs(angle) > 0.02) {
    scene.shapes.push_back(arc(hinge, 0.42 * settings_.poleLength, 0, angle, Ink::Outline));
    scene.shapes.push_back(
        Label{polar(hinge, 0.42 * settings_.poleLength, 0), "α", angle > 0 ? -10.0 : 10.0, 0, 0, Ink::Solid});
  }
  scene.shapes.push_back(Polyline{{hinge, scene.tip}, Ink::Body, 8});
  scene.shapes.push_back(Disc{hinge, 0.105 * r, Fill::Panel, Ink::Solid, 2});

  if (torque != 0.0) {
    const double side = torque > 0 ? 1.0 : -1.0, share = torque / (settings_.torqueScale * task_.actions.back());
    scene.shapes.push_back(Arrow{{x + side * kArrowAt * r, r}, share * longest, fixedText(torque, 2) + " N m"});
  }
}

std::vector<ReadOut> Pendulum::readOuts(std::span<const double> pose) const {
  return {{"α", "rad", pose[1]}, {"α\u0307", "rad/s", pose[2]}, {"β\u0307", "rad/s", pose[3]}, {"T", "N m", pose[4]}};
}

}  // namespace surefoot
