// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by worlds of states in a row: the picture, a disc on a line of cells between two ends.
#pragma once

#include "core/environments/grid.h"

namespace surefoot {

/// States `first` … `last`; the places before and behind are drawn, too, if they are the ends of an episode.
struct Corridor {
  int first = 1, last = 10;
  bool endsOutside = false;

  void draw(Scene& scene, double position, const char* leftEnd, const char* rightEnd) const;
};

}  // namespace surefoot
