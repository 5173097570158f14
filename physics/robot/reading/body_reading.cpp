// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/reading/sections.h"

namespace surefoot {

namespace {

constexpr std::pair<const char*, Ink> kInks[] = {
    {"solid", Ink::Solid}, {"body", Ink::Body},         {"far", Ink::Far},  {"outline", Ink::Outline},
    {"quiet", Ink::Quiet}, {"hairline", Ink::Hairline}, {"fall", Ink::Fall}};
constexpr std::pair<const char*, Fill> kFills[] = {
    {"none", Fill::None}, {"panel", Fill::Panel}, {"wash", Fill::Wash}, {"solid", Fill::Solid}, {"far", Fill::Far}};
constexpr std::pair<const char*, Meets> kMeets[] = {
    {"ground", Meets::Ground}, {"all", Meets::All}, {"nothing", Meets::Nothing}};

/// What circle, box, polygon and rod have of their own.
void readForm(TomlReader& reader, RobotReader& in, ShapeSpec& shape) {
  using Form = ShapeSpec::Kind;
  int forms = 0;
  for (const auto& [key, kind] : {std::pair{"circle", Form::Circle}, std::pair{"box", Form::Box},
                                  std::pair{"polygon", Form::Polygon}, std::pair{"rod", Form::Rod}})
    if (reader.find(key)) shape.kind = kind, ++forms;
  if (forms != 1)
    return in.complaints().push_back({shape.place, "a shape is one of circle, box, polygon and rod."}), void();
  switch (shape.kind) {
    case Form::Circle:
      shape.radius = in.number(reader, "circle", 0);
      break;
    case Form::Box:
      shape.size = in.pair(reader, "box", 0, 0);
      break;
    case Form::Polygon:
      shape.corners = in.pairs(reader, "polygon");
      if (shape.corners.size() < 3 || shape.corners.size() > kMostCorners)
        reader.complain("polygon",
                        fmt::format("it has {} corners; it takes 3 to {}.", shape.corners.size(), kMostCorners));
      break;
    case Form::Rod:
      shape.radius = in.number(reader, "rod", 0);
      reader.need("to");
      shape.to = in.pair(reader, "to", 0, 0);
      break;
  }
}

ShapeSpec readShape(const TomlNode& node, RobotReader& in, const ShapeSpec& usual) {
  TomlReader reader(node, in.complaints());
  ShapeSpec shape = usual;
  shape.place = node.at;
  shape.name = reader.text("name");
  readForm(reader, in, shape);
  shape.at = in.pair(reader, "at", 0, 0);
  shape.angle = in.number(reader, "angle", 0);
  shape.meets = in.choice(reader, "meets", kMeets, usual.meets);
  if (const auto friction = in.maybe(reader, "friction")) shape.friction = *friction;
  if (const auto restitution = in.maybe(reader, "restitution")) shape.restitution = *restitution;
  if (const auto density = in.maybe(reader, "density")) shape.density = *density;
  shape.solid = in.maybe(reader, "solid", RobotReader::Where::Moving, ValueKind::Flag);
  shape.ink = in.choice(reader, "ink", kInks, usual.ink);
  shape.fill = in.choice(reader, "fill", kFills, usual.fill);
  shape.width = reader.number("width", 0, 50, usual.width);
  shape.drawn = reader.flag("drawn", true);
  reader.end();
  return shape;
}

BodySpec readBody(const std::string& name, const TomlNode& node, RobotReader& in) {
  TomlReader reader(node, in.complaints());
  BodySpec body{.name = name, .place = node.keyAt};
  body.at = in.pair(reader, "at", 0, 0);
  body.angle = in.number(reader, "angle", 0);
  body.mass = in.maybe(reader, "mass");
  body.inertia = in.maybe(reader, "inertia");
  body.inertiaAtOrigin = in.maybe(reader, "inertia_at_origin");
  body.centre = in.maybePair(reader, "centre");
  body.rotates = reader.flag("rotates", true);
  body.still = reader.flag("still");
  const bool dense = reader.find("density") != nullptr;
  ShapeSpec usual;
  usual.friction = in.number(reader, "friction", 0.2);
  usual.restitution = in.number(reader, "restitution", 0);
  usual.density = in.number(reader, "density", 0);
  usual.meets = in.choice(reader, "meets", kMeets, Meets::Ground);
  usual.ink = in.choice(reader, "ink", kInks, Ink::Solid);
  usual.fill = in.choice(reader, "fill", kFills, Fill::Panel);
  for (const TomlNode* shape : reader.tables("shape")) body.shapes.push_back(readShape(*shape, in, usual));
  if (!reader.end()) return body;  // a key that is misspelt is missing, too

  const TomlNode* mass = node.find("mass");
  const bool inertia = body.inertia || body.inertiaAtOrigin || !body.rotates;
  if (!body.still && mass && !inertia && !dense)
    in.complaints().push_back(
        {mass->at, fmt::format("[body.{}] has a mass but no inertia [kg m²] about its centre; give it, or density, or "
                               "rotates = false.",
                               name)});
  if (!body.still && !mass && !dense)
    in.complaints().push_back({body.place, fmt::format("[body.{}] has neither a mass nor a density.", name)});
  if (mass && dense)
    in.complaints().push_back(
        {mass->at,
         fmt::format("[body.{}] has a mass and a density; give either a mass with an inertia, or a density.", name)});
  return body;
}

}  // namespace

void readBodies(const TomlNode& root, RobotReader& in) {
  const TomlNode* all = root.find("body");
  std::size_t shapes = 0;
  for (const auto& [name, node] : all ? all->table : decltype(all->table){}) {
    in.spec().bodies.push_back(readBody(name, node, in));
    shapes += in.spec().bodies.back().shapes.size();
  }
  if (shapes > kMostShapes)
    in.complaints().push_back({all->at, fmt::format("{} shapes; at most {} are allowed.", shapes, kMostShapes)});
}

void readPoints(const TomlNode& root, RobotReader& in) {
  const TomlNode* points = root.find("point");
  for (const auto& [name, node] : points ? points->table : decltype(points->table){}) {
    TomlReader reader(node, in.complaints());
    PointSpec& point = in.spec().points.emplace_back();
    if (in.spec().names.hasChild()) {
      reader.need("at");
      if (const auto at = in.maybePair(reader, "at", RobotReader::Where::Moving)) point.at = *at;
      reader.end();
      continue;
    }
    reader.need("on");
    point.body = in.indexOf(reader, "on", NameKind::Body, 0);
    point.at = in.pair(reader, "at", 0, 0);
    reader.end();
  }
  const TomlNode* rays = root.find("ray");
  for (const auto& [name, node] : rays ? rays->table : decltype(rays->table){}) {
    TomlReader reader(node, in.complaints());
    reader.need("from");
    RaySpec& ray = in.spec().rays.emplace_back();
    ray.point = in.indexOf(reader, "from", NameKind::Point, 0);
    ray.angle = in.number(reader, "angle", 0);
    ray.length = in.needed(reader, "length");
    reader.end();
  }
}

}  // namespace surefoot
