// SPDX-License-Identifier: GPL-3.0-or-later
// Figures that are pictures of worlds and of tilings: made from a condition's configuration, not from its lives.
#include "core/recipes/live_scene.h"

#include <fmt/format.h>

#include "core/experiment/configuration_json.h"
#include "core/features/tile_layout.h"

namespace surefoot {

namespace {

Ink inkOf(int tiling) {
  constexpr Ink kInks[] = {Ink::Solid, Ink::Outline, Ink::Quiet};
  return kInks[static_cast<std::size_t>(tiling) % 3];
}

/// In units of tiles, so that a tile is a square.
Point inTiles(const TileLayout& tiles, double x, double y) {
  return {x / tiles.width(0), y / tiles.width(1)};
}

/// The tile of tiling i that holds a state.
Polygon tileAt(const TileLayout& tiles, int i, std::span<const double> state) {
  const auto [left, right] = tiles.tileAt(0, i, state[0]);
  const auto [bottom, top] = tiles.tileAt(1, i, state[1]);
  return {.points = {inTiles(tiles, left, bottom), inTiles(tiles, right, bottom), inTiles(tiles, right, top),
                     inTiles(tiles, left, top)},
          .ink = inkOf(i)};
}

void drawGrid(const TileLayout& tiles, int i, Scene& scene) {
  const auto line = [&](double x0, double y0, double x1, double y1) {
    scene.shapes.push_back(Polyline{.points = {inTiles(tiles, x0, y0), inTiles(tiles, x1, y1)},
                                    .ink = inkOf(i),
                                    .width = 1.0,
                                    .dashed = inkOf(i) == Ink::Quiet});
  };
  const double left = tiles.edge(0, i, 0), right = tiles.edge(0, i, tiles.tiles(0));
  const double bottom = tiles.edge(1, i, 0), top = tiles.edge(1, i, tiles.tiles(1));
  for (double k = 0; k <= tiles.tiles(0); ++k) line(tiles.edge(0, i, k), bottom, tiles.edge(0, i, k), top);
  for (double k = 0; k <= tiles.tiles(1); ++k) line(left, tiles.edge(1, i, k), right, tiles.edge(1, i, k));
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
  const auto tiles = TileLayout::fromJson((*agent)->layouts()["q"]);
  if (!tiles) return Error{"features: a tile coder is needed"};
  Figure figure{.name = spec.name,
                .title = spec.title,
                .xTitle = task.state[0].title,
                .yTitle = task.state[1].title,
                .labels = {},
                .series = {}};
  Scene& scene = figure.scene.emplace();
  for (int i = 0; i < tiles->tilings(); ++i) {
    Polygon tile = tileAt(*tiles, i, spec.state);
    tile.width = 0;
    scene.shapes.push_back(tile);
  }
  for (int i = 0; i < tiles->tilings(); ++i) drawGrid(*tiles, i, scene);
  for (int i = 0; i < tiles->tilings(); ++i) {
    Polygon tile = tileAt(*tiles, i, spec.state);
    tile.fill = Fill::None;
    tile.width = 2.5;
    scene.shapes.push_back(tile);
  }
  constexpr double kArm = 0.12;  // arm of the cross [tiles]
  const Point at = inTiles(*tiles, spec.state[0], spec.state[1]);
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
