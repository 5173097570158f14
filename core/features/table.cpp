// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace surefoot {

Result<Table> Table::create(const Task& task) {
  constexpr double kMostStates = 1e7;
  Table table;
  double states = 1.0;
  for (const StateVariable& v : task.state) {
    if (!v.whole)
      return Error{fmt::format(
          "features: a table needs states of whole numbers, and the {} has others; take the tile-coder.", v.title)};
    table.dimensions_.push_back({v.low, v.high, static_cast<Index>(states)});
    states *= v.high - v.low + 1;
    if (states > kMostStates)
      return Error{fmt::format("features: a table of {:.3g} states is too large; take the tile-coder.", states)};
  }
  table.size_ = static_cast<Index>(states);
  return table;
}

bool Table::activeFeatures(std::span<const double> state, std::span<Index> out) const {
  bool inside = true;
  out[0] = 0;
  for (std::size_t d = 0; d < dimensions_.size(); ++d) {
    const Dimension& dim = dimensions_[d];
    double x = std::round(state[d]);
    if (!(x >= dim.low)) x = dim.low, inside = false;
    if (x > dim.high) x = dim.high, inside = false;
    out[0] += static_cast<Index>(x - dim.low) * dim.stride;
  }
  return inside;
}

}  // namespace surefoot
