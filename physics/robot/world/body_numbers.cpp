// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/basics/portable_math.h"
#include "physics/robot/world/checked.h"
#include "physics/robot/world/masses.h"
#include "physics/robot/world/number_parts.h"

namespace surefoot {

Point rotated(Point v, double angle) {
  const double c = portableCos(angle), s = portableSin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

namespace {

constexpr double kSmallestRadius = 1e-5;  // [m]

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
  if (spec.inertia) body.inertiaAtOrigin = number(*spec.inertia, where, "inertia", 0, kMostOfAnything, "kg m²") + arm;
  if (spec.inertiaAtOrigin)
    body.inertiaAtOrigin = number(*spec.inertiaAtOrigin, where, "inertia_at_origin", 0, kMostOfAnything, "kg m²");
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

}  // namespace

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

}  // namespace surefoot
