// SPDX-License-Identifier: GPL-3.0-or-later
// Area, centre and inertia of plane shapes of a density.
#pragma once

#include "physics/robot/world/robot_numbers.h"

namespace surefoot {

struct MassOf {
  double mass = 0.0;
  Point centre{};
  double inertia = 0.0;  ///< about the origin of the body

  void add(const MassOf& other);
};

/// Of a shape with `density` [kg/m²]. A rod is a box with two half discs.
MassOf massOf(const ShapeNumbers& shape, double density);

/// The corners of a box or polygon in its body's frame.
std::vector<Point> cornersOf(const ShapeNumbers& shape);
/// Twice the area, with a sign: positive if the corners go counter-clockwise.
double signedArea(const std::vector<Point>& corners);
/// Whether every corner turns the same way.
bool isConvex(const std::vector<Point>& corners);

}  // namespace surefoot
