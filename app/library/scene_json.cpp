// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/library/scene_json.h"

namespace surefoot {

using OrderedJson = nlohmann::ordered_json;

namespace {

const char* nameOf(Ink ink) {
  constexpr const char* kInks[] = {"solid", "body", "far", "outline", "quiet", "hairline", "fall"};
  return kInks[static_cast<std::size_t>(ink)];
}
const char* nameOf(Fill fill) {
  constexpr const char* kFills[] = {"none", "panel", "wash", "solid", "far", "fall"};
  return kFills[static_cast<std::size_t>(fill)];
}

OrderedJson json(Point p) {
  return OrderedJson::array({p.x, p.y});
}
OrderedJson json(const std::vector<Point>& points) {
  OrderedJson list = OrderedJson::array();
  for (const Point p : points) list.push_back(json(p));
  return list;
}

OrderedJson json(const Polyline& s) {
  return {
      {"shape", "line"}, {"points", json(s.points)}, {"ink", nameOf(s.ink)}, {"width", s.width}, {"dashed", s.dashed}};
}
OrderedJson json(const Polygon& s) {
  return {{"shape", "polygon"},
          {"points", json(s.points)},
          {"fill", nameOf(s.fill)},
          {"ink", nameOf(s.ink)},
          {"width", s.width}};
}
OrderedJson json(const Disc& s) {
  return {{"shape", "disc"},        {"centre", json(s.centre)}, {"radius", s.radius},
          {"fill", nameOf(s.fill)}, {"ink", nameOf(s.ink)},     {"width", s.width}};
}
OrderedJson json(const Arrow& s) {
  return {{"shape", "arrow"}, {"from", json(s.from)}, {"length", s.length}, {"text", s.text}};
}
OrderedJson json(const Label& s) {
  return {{"shape", "label"}, {"at", json(s.at)}, {"text", s.text}};
}

}  // namespace

OrderedJson sceneAsJson(const Scene& scene) {
  OrderedJson shapes = OrderedJson::array();
  for (const Shape& shape : scene.shapes) shapes.push_back(std::visit([](const auto& s) { return json(s); }, shape));
  return {{"focus", json(scene.focus)},
          {"height", scene.height},
          {"width", scene.width},
          {"metres", scene.metres},
          {"shapes", std::move(shapes)}};
}

}  // namespace surefoot
