// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/world/masses.h"

#include <cmath>
#include <numbers>

#include "core/basics/portable_math.h"

namespace surefoot {

namespace {

double cross(Point a, Point b) {
  return a.x * b.y - a.y * b.x;
}

MassOf disc(Point centre, double radius, double density) {
  const double mass = density * std::numbers::pi * radius * radius;
  return {mass, centre, mass * (0.5 * radius * radius + centre.x * centre.x + centre.y * centre.y)};
}

MassOf polygon(const std::vector<Point>& corners, double density) {
  MassOf all;
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i], b = corners[(i + 1) % corners.size()];
    const double part = cross(a, b);
    area += part;
    all.centre.x += part * (a.x + b.x), all.centre.y += part * (a.y + b.y);
    all.inertia += part * (a.x * a.x + a.x * b.x + b.x * b.x + a.y * a.y + a.y * b.y + b.y * b.y);
  }
  if (area == 0.0) return {};
  all.centre.x /= 3.0 * area, all.centre.y /= 3.0 * area;
  all.mass = density * std::abs(area) / 2.0;
  all.inertia = density * std::abs(all.inertia) / 12.0;
  return all;
}

std::vector<Point> rodSides(const ShapeNumbers& rod) {
  const double dx = rod.to.x - rod.at.x, dy = rod.to.y - rod.at.y, length = std::sqrt(dx * dx + dy * dy);
  const double nx = -dy / length * rod.radius, ny = dx / length * rod.radius;
  return {{rod.at.x - nx, rod.at.y - ny},
          {rod.to.x - nx, rod.to.y - ny},
          {rod.to.x + nx, rod.to.y + ny},
          {rod.at.x + nx, rod.at.y + ny}};
}

}  // namespace

void MassOf::add(const MassOf& other) {
  const double whole = mass + other.mass;
  if (whole <= 0.0) return;
  centre = {(mass * centre.x + other.mass * other.centre.x) / whole,
            (mass * centre.y + other.mass * other.centre.y) / whole};
  mass = whole;
  inertia += other.inertia;
}

std::vector<Point> cornersOf(const ShapeNumbers& shape) {
  if (shape.kind == ShapeSpec::Kind::Rod) return rodSides(shape);
  std::vector<Point> corners = shape.corners;
  const double w = 0.5 * shape.size.x, h = 0.5 * shape.size.y;
  if (shape.kind == ShapeSpec::Kind::Box) corners = {{-w, -h}, {w, -h}, {w, h}, {-w, h}};
  const double c = portableCos(shape.angle), s = portableSin(shape.angle);
  for (Point& p : corners) p = {shape.at.x + c * p.x - s * p.y, shape.at.y + s * p.x + c * p.y};
  return corners;
}

double signedArea(const std::vector<Point>& corners) {
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) area += cross(corners[i], corners[(i + 1) % corners.size()]);
  return area;
}

bool isConvex(const std::vector<Point>& corners) {
  const double turn = signedArea(corners);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i], b = corners[(i + 1) % corners.size()], c = corners[(i + 2) % corners.size()];
    if (turn * cross({b.x - a.x, b.y - a.y}, {c.x - b.x, c.y - b.y}) <= 0.0) return false;
  }
  return true;
}

MassOf massOf(const ShapeNumbers& shape, double density) {
  if (shape.kind == ShapeSpec::Kind::Circle) return disc(shape.at, shape.radius, density);
  MassOf all = polygon(cornersOf(shape), density);
  if (shape.kind != ShapeSpec::Kind::Rod) return all;
  // Each half disc: of a disc's mass, its centre 4r/3π beyond the end, its inertia half of the disc's about the end.
  const double dx = shape.to.x - shape.at.x, dy = shape.to.y - shape.at.y, length = std::sqrt(dx * dx + dy * dy);
  const double r = shape.radius, out = 4.0 * r / (3.0 * std::numbers::pi);
  const double half = density * std::numbers::pi * r * r / 2.0;
  for (const double side : {-1.0, 1.0}) {
    const Point end = side < 0 ? shape.at : shape.to;
    const Point centre{end.x + side * out * dx / length, end.y + side * out * dy / length};
    const double about = half * (0.5 * r * r - out * out);  // about its own centre
    all.add({half, centre, about + half * (centre.x * centre.x + centre.y * centre.y)});
  }
  return all;
}

}  // namespace surefoot
