// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/tile_grid.h"
#include "core/basics/expects.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

namespace surefoot {

/// Everything of one variable but the strides.
template <class Number>
auto TileGrid<Number>::layOut(const StateVariable& v, const TileSettings& settings, std::size_t d)
    -> Result<Dimension> {
  const int n = settings.tilings;
  Dimension dim;
  dim.key = v.key;
  dim.scale = settings.tilesPerUnit(d) * n;
  dim.wraps = v.period.has_value();
  if (!dim.wraps) {
    dim.from = settings.from[d];
    dim.to = settings.to[d];
    if (!(dim.from < dim.to))
      return Error{
          fmt::format("features.{0}_from = {1} and features.{0}_to = {2}: the box is empty; the first must be "
                      "below the second.",
                      v.key, dim.from, dim.to)};
    dim.closedBelow = dim.from > v.low;
    dim.closedAbove = dim.to < v.high;
    dim.low = std::floor(dim.from * dim.scale);
    dim.high = std::floor(dim.to * dim.scale);
    dim.origin = std::floor(dim.low / n) * n;
    dim.cycle = static_cast<Number>(n);
    dim.tiles = std::floor((dim.high - dim.origin + n - 1) / n) + 1;
    return dim;
  }
  constexpr double kMostAround = 1000;
  const double wanted = settings.tilesPerUnit(d) * *v.period;
  dim.tiles = std::round(wanted);
  if (dim.tiles < 1 || dim.tiles > kMostAround || std::abs(dim.tiles - wanted) > 1e-9 * dim.tiles)
    return Error{fmt::format("features.{}: {} tiles in one turn of the {}; a variable that wraps needs a whole number.",
                             v.key, wanted, v.title)};
  dim.cycle = static_cast<Number>(dim.tiles) * static_cast<Number>(n);
  dim.scale = dim.tiles * n / *v.period;
  return dim;
}

template <class Number>
Result<TileGrid<Number>> TileGrid<Number>::create(const Task& task, const TileSettings& settings, double mostTiles) {
  TileGrid grid;
  const int n = grid.tilings_ = settings.tilings;
  expects(!task.state.empty() && task.state.size() <= kMaxStateVariables, "a task has a state");
  double stride = n;  // tiles along the dimensions so far, of all tilings
  for (std::size_t d = 0; d < task.state.size(); ++d) {
    const StateVariable& v = task.state[d];
    Result<Dimension> dim = layOut(v, settings, d);
    if (!dim) return dim.error();
    if (stride * dim->tiles > mostTiles)
      return Error{
          fmt::format("features.{}: {} tilings with features.scale = {} have {:.3g} tiles; at most {:.3g} are "
                      "allowed, so take fewer tilings, fewer tiles, a smaller scale, or a hashed table "
                      "(features.memory).",
                      v.key, n, settings.scale, stride * dim->tiles, mostTiles)};
    if (std::has_single_bit(dim->cycle)) dim->shift = std::countr_zero(dim->cycle);
    dim->cycleStride = dim->wraps ? 0 : static_cast<Number>(stride);
    for (Number position = 0; position < dim->cycle; ++position)
      for (int i = 0; i < n; ++i) {
        const auto displacement = static_cast<Number>(i * (2 * static_cast<int>(d) + 1) % n);
        Number tile = (position + displacement) / static_cast<Number>(n);
        if (dim->wraps) tile %= static_cast<Number>(dim->tiles);
        dim->carry.push_back(tile * static_cast<Number>(stride) + (d == 0 ? static_cast<Number>(i) : 0));
      }
    stride *= dim->tiles;
    grid.dimensions_.push_back(std::move(*dim));
  }
  grid.size_ = static_cast<Number>(stride);
  return grid;
}

template <class Number>
Cover TileGrid<Number>::find(std::span<const double> state, std::span<Number> out) const {
  const auto n = static_cast<std::size_t>(tilings_);
  Cover cover = Cover::Inside;
  Number base = 0;
  std::array<const Number*, kMaxStateVariables> carries;
  for (std::size_t d = 0; d < dimensions_.size(); ++d) {
    const Dimension& dim = dimensions_[d];
    double step = std::floor(state[d] * dim.scale);
    Number position = 0;
    if (dim.wraps) {
      if (!std::isfinite(step)) step = 0, cover = Cover::Edge;
      const auto cycle = static_cast<double>(dim.cycle);
      step -= std::floor(step / cycle) * cycle;
      position = static_cast<Number>(step);
    } else {
      if ((dim.closedBelow && !(state[d] >= dim.from)) || (dim.closedAbove && !(state[d] <= dim.to)))
        return Cover::Nothing;
      if (!(step >= dim.low)) step = dim.low, cover = Cover::Edge;  // NaN too
      if (step > dim.high) step = dim.high, cover = Cover::Edge;
      position = static_cast<Number>(step - dim.origin);
    }
    const Number cycles = dim.shift >= 0 ? position >> dim.shift : position / dim.cycle;
    base += cycles * dim.cycleStride;
    carries[d] = &dim.carry[(position - cycles * dim.cycle) * n];
  }
  for (std::size_t i = 0; i < n; ++i) out[i] = base + carries[0][i];
  for (std::size_t d = 1; d < dimensions_.size(); ++d)
    for (std::size_t i = 0; i < n; ++i) out[i] += carries[d][i];
  return cover;
}

template <class Number>
nlohmann::json TileGrid<Number>::layout() const {
  nlohmann::json variables = nlohmann::json::array();
  for (std::size_t d = 0; d < dimensions_.size(); ++d) {
    const Dimension& dim = dimensions_[d];
    variables.push_back({{"variable", dim.key},
                         {"tile_width", tilings_ / dim.scale},
                         {"tiles", static_cast<std::int64_t>(dim.tiles)},
                         {"steps_per_unit", dim.scale},
                         {"first_step", dim.low},
                         {"last_step", dim.high},
                         {"origin_step", dim.origin},
                         {"displacement", 2 * d + 1},
                         {"wraps", dim.wraps},
                         {"nothing_below", dim.closedBelow ? nlohmann::json(dim.from) : nullptr},
                         {"nothing_above", dim.closedAbove ? nlohmann::json(dim.to) : nullptr}});
  }
  return {{"kind", "tile-coder"}, {"tilings", tilings_}, {"variables", variables}};
}

template <class Number>
std::vector<std::size_t> TileGrid<Number>::shape() const {
  std::vector<std::size_t> shape;
  for (auto dim = dimensions_.rbegin(); dim != dimensions_.rend(); ++dim)
    shape.push_back(static_cast<std::size_t>(dim->tiles));
  shape.push_back(static_cast<std::size_t>(tilings_));
  return shape;
}

template class TileGrid<std::uint32_t>;
template class TileGrid<std::uint64_t>;

}  // namespace surefoot
