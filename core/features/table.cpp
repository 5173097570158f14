// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace surefoot {

Result<Table> Table::create(const Task& task) {
  constexpr double kMostStates = 1e7;
  Table table;
  double states = 1.0;
  for (const StateVariable& v : task.state) {
    if (!v.whole)
      return Error{fmt::format(
          "features: a table needs states of whole numbers, and the {} has others; take the tile-coder.", v.title)};
    table.dimensions_.push_back({v.key, v.low, v.high, static_cast<Index>(states)});
    states *= v.high - v.low + 1;
    if (states > kMostStates)
      return Error{fmt::format("features: a table of {:.3g} states is too large; take the tile-coder.", states)};
  }
  table.size_ = static_cast<Index>(states);
  return table;
}

Cover Table::find(std::span<const double> state, Active& x) const {
  Cover cover = Cover::Inside;
  x.count = 1;
  x.index[0] = 0;
  for (std::size_t d = 0; d < dimensions_.size(); ++d) {
    const Dimension& dim = dimensions_[d];
    double value = std::round(state[d]);
    if (!(value >= dim.low)) value = dim.low, cover = Cover::Edge;
    if (value > dim.high) value = dim.high, cover = Cover::Edge;
    x.index[0] += static_cast<Index>(value - dim.low) * dim.stride;
  }
  return cover;
}

nlohmann::json Table::layout() const {
  nlohmann::json variables = nlohmann::json::array();
  for (const Dimension& dim : dimensions_)
    variables.push_back({{"variable", dim.key}, {"lowest", dim.low}, {"highest", dim.high}});
  return {{"kind", "table"}, {"variables", variables}};
}

std::vector<std::size_t> Table::shape() const {
  std::vector<std::size_t> shape;
  for (auto dim = dimensions_.rbegin(); dim != dimensions_.rend(); ++dim)
    shape.push_back(static_cast<std::size_t>(dim->high - dim->low) + 1);
  return shape;
}

}  // namespace surefoot
