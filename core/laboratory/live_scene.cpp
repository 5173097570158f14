// SPDX-License-Identifier: GPL-3.0-or-later
// Figures that are pictures of worlds and of tilings: made from a condition's configuration, not from its lives.
#include "core/laboratory/live_scene.h"

#include <fmt/format.h>

#include <cmath>

#include "core/experiment/configuration_json.h"

namespace surefoot {

namespace {

/// One dimension of a tile coder, in steps of a tile's width divided by the number of tilings (see TileGrid).
struct Axis {
  double tiles, perUnit, origin, displacement, tilings;
  /// The k-th edge of tiling i, in tiles.
  double edge(double k, double i) const {
    return (origin + k * tilings - std::fmod(i * displacement, tilings)) / tilings;
  }
  double inTiles(double value) const { return value * perUnit / tilings; }
  /// The tile of tiling i that holds a value.
  double tileOf(double value, double i) const {
    return std::floor((value * perUnit - origin + std::fmod(i * displacement, tilings)) / tilings);
  }
};

Axis axisOf(const nlohmann::json& layout, std::size_t d) {
  const auto& v = layout["variables"][d];
  return {v["tiles"], v["steps_per_unit"], v["origin_step"], v["displacement"], layout["tilings"]};
}

Ink inkOf(double tiling) {
  constexpr Ink kInks[] = {Ink::Solid, Ink::Outline, Ink::Quiet};
  return kInks[static_cast<std::size_t>(tiling) % 3];
}

/// The tile of tiling i that holds a state.
Polygon tileAt(const Axis& x, const Axis& y, double i, std::span<const double> state) {
  const double left = x.edge(x.tileOf(state[0], i), i), bottom = y.edge(y.tileOf(state[1], i), i);
  return {.points = {{left, bottom}, {left + 1, bottom}, {left + 1, bottom + 1}, {left, bottom + 1}}, .ink = inkOf(i)};
}

void drawGrid(const Axis& x, const Axis& y, double i, Scene& scene) {
  const auto line = [&](Point from, Point to) {
    scene.shapes.push_back(
        Polyline{.points = {from, to}, .ink = inkOf(i), .width = 1.0, .dashed = inkOf(i) == Ink::Quiet});
  };
  for (double k = 0; k <= x.tiles; ++k) line({x.edge(k, i), y.edge(0, i)}, {x.edge(k, i), y.edge(y.tiles, i)});
  for (double k = 0; k <= y.tiles; ++k) line({x.edge(0, i), y.edge(k, i)}, {x.edge(x.tiles, i), y.edge(k, i)});
}

}  // namespace

Result<Figure> drawWorld(const Registry& registry, const FigureSpec& spec, const Configuration& c) {
  auto environment = makeEnvironment(registry, c);
  if (!environment) return environment.error();
  Random random(c.seed);
  (*environment)->reset(random);
  const auto strongest = static_cast<Action>((*environment)->task().actions.size() - 1);
  static_cast<void>((*environment)->step(strongest));  // so that there is a torque to see
  Figure figure{.name = spec.name, .title = spec.title, .xTitle = {}, .yTitle = {}, .labels = {}, .series = {}};
  const auto pose = (*environment)->pose();
  (*environment)->draw(pose, figure.scene.emplace());
  for (const ReadOut& r : (*environment)->readOuts(pose))
    figure.xTitle +=
        fmt::format("{}{} = {:.{}f} {}", figure.xTitle.empty() ? "" : "   ", r.symbol, r.value, r.decimals, r.unit);
  return figure;
}

Result<Figure> drawTilings(const Registry& registry, const FigureSpec& spec, const Configuration& c) {
  const auto environment = makeEnvironment(registry, c);
  if (!environment) return environment.error();
  const Task& task = (*environment)->task();
  if (task.state.size() != 2 || spec.state.size() != 2 || c.names.features != "tile-coder")
    return Error{"state: a tile coder over two state variables is needed, and a state"};
  const auto entry = findEntry(registry.agents, "agent", c.names.agent);
  if (!entry) return entry.error();
  const auto agent = (*entry)->make({task, c.names.features, c.parameters, 0});
  if (!agent) return agent.error();
  const nlohmann::json layout = (*agent)->layouts()["q"];
  const Axis x = axisOf(layout, 0), y = axisOf(layout, 1);
  Figure figure{.name = spec.name,
                .title = spec.title,
                .xTitle = task.state[0].title,
                .yTitle = task.state[1].title,
                .labels = {},
                .series = {}};
  Scene& scene = figure.scene.emplace();
  for (double i = 0; i < x.tilings; ++i) {
    Polygon tile = tileAt(x, y, i, spec.state);
    tile.width = 0;
    scene.shapes.push_back(tile);
  }
  for (double i = 0; i < x.tilings; ++i) drawGrid(x, y, i, scene);
  for (double i = 0; i < x.tilings; ++i) {
    Polygon tile = tileAt(x, y, i, spec.state);
    tile.fill = Fill::None;
    tile.width = 2.5;
    scene.shapes.push_back(tile);
  }
  constexpr double kArm = 0.12;  // of the cross [tiles]
  const Point at{x.inTiles(spec.state[0]), y.inTiles(spec.state[1])};
  for (const double sign : {-1.0, 1.0})
    scene.shapes.push_back(Polyline{.points = {{at.x - kArm, at.y - sign * kArm}, {at.x + kArm, at.y + sign * kArm}},
                                    .ink = Ink::Fall,
                                    .width = 3});
  return figure;
}

std::string sceneAsCsv(const Scene& scene) {
  std::string csv = "shape,x,y\n";
  int number = 0;
  const auto add = [&](const char* kind, const std::vector<Point>& points) {
    ++number;
    for (const Point& p : points) csv += fmt::format("{} {},{:.9g},{:.9g}\n", kind, number, p.x, p.y);
  };
  for (const Shape& shape : scene.shapes) {
    if (const auto* line = std::get_if<Polyline>(&shape)) add("line", line->points);
    if (const auto* polygon = std::get_if<Polygon>(&shape)) add("polygon", polygon->points);
    if (const auto* disc = std::get_if<Disc>(&shape)) add("disc", {disc->centre});
  }
  return csv;
}

}  // namespace surefoot
