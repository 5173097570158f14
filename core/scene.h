// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of a world as plain shapes in metres, so that the window can draw any environment without knowing it.
// x points right, y up, y = 0 is the floor.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace surefoot {

struct Point {
  double x = 0.0, y = 0.0;  // [m]
};

/// The role of a line; the theme chooses its colour. `Body` is solid, too, but turns to the colour of
/// falling while the window shows a fall; `Far` is the side of a body that is turned away from the eye.
enum class Ink { Solid, Body, Far, Outline, Quiet, Hairline, Fall };
enum class Fill { None, Panel, Wash, Solid, Far, Fall };

struct Polyline {
  std::vector<Point> points;
  Ink ink = Ink::Outline;
  double width = 1.0;  // [px]: line widths do not grow with the zoom; in a small picture they are thinner
  bool dashed = false;
};

struct Polygon {
  std::vector<Point> points;
  Fill fill = Fill::Wash;
  Ink ink = Ink::Solid;
  double width = 2.0;  // [px], 0: no outline
};

struct Disc {
  Point centre;
  double radius = 0.0;  // [m]
  Fill fill = Fill::Panel;
  Ink ink = Ink::Solid;
  double width = 2.0;  // [px], 0: no outline
};

/// A torque or a force, as an arrow from `from` along x; `length` carries the sign. Its head comes behind.
struct Arrow {
  static constexpr double kHead = 0.0105;  ///< [m], at most
  Point from;
  double length = 0.0;  // [m]
  std::string text;
};

struct Label {
  Point at;
  std::string text;
  double dx = 0.0, dy = 0.0;  // [px], right and down
  int align = 0;              // −1: ends at the point, 0: centred, 1: begins there
  Ink ink = Ink::Quiet;
  bool halo = false;  // may lie over a body: nothing of it shows between the letters
  double room = 0.0;  // [m] that it may be wide: smaller text, or none, where that is too little; 0: any
};

using Shape = std::variant<Polyline, Polygon, Disc, Arrow, Label>;

struct Scene {
  std::vector<Shape> shapes;
  Point focus;          ///< the camera follows it horizontally
  double height = 0.3;  ///< [m] from the floor to the highest thing drawn: must be visible
  double width = 0.0;   ///< [m] around the focus that must be visible; 0: only the height counts
  bool metres = true;   ///< draw the floor with a metre scale
  Point tip;            ///< leaves the fading trail
  /// Empties the scene, but keeps the memory of the shapes.
  void clear() {
    std::vector<Shape> kept = std::move(shapes);
    kept.clear();
    *this = {};
    shapes = std::move(kept);
  }
};

}  // namespace surefoot
