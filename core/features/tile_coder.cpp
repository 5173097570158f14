// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/tile_coder.h"

#include <fmt/format.h>

#include <cmath>

namespace surefoot {

namespace {
constexpr double kMostWeights = 1u << 27;  // of all actions together: 1 GiB of doubles
}

TileCoder::Settings::Settings(const Task& task) : variables_(task.state) {
  for (const StateVariable& v : task.state) resolution.push_back(v.resolution);
}

void TileCoder::Settings::declare(Fields& f) {
  f.integer(tilings, {.key = "tilings",
                      .title = "Tilings",
                      .symbol = "",
                      .unit = "",
                      .low = 1,
                      .high = kMostActive,
                      .sliderLow = 1,
                      .sliderHigh = 32,
                      .when = When::NewTable,
                      .group = Group::Representation,
                      .help = "Displaced grids that lie over each other; a power of two is best.",
                      .origin = "thesis, section 3.1.3"});
  for (std::size_t d = 0; d < variables_.size(); ++d) {
    const StateVariable& v = variables_[d];
    std::string title = v.title;
    title[0] = static_cast<char>(std::toupper(title[0]));
    f.real(resolution[d], {.key = v.key,
                           .title = title,
                           .symbol = v.symbol,
                           .unit = v.perSpan,
                           .low = 0.01,
                           .high = 1000,
                           .sliderLow = 1,
                           .sliderHigh = 32,
                           .when = When::NewTable,
                           .group = Group::Representation,
                           .help = fmt::format("Tiles per {} of the {}: few generalise far, many tell states apart.",
                                               v.spanText, v.title),
                           .origin = "thesis, section 3.1.3"});
  }
  f.real(scale, {.key = "scale",
                 .title = "Scale",
                 .symbol = "",
                 .unit = "×",
                 .low = 0.01,
                 .high = 100,
                 .sliderLow = 0.1,
                 .sliderHigh = 2,
                 .when = When::NewTable,
                 .group = Group::Representation,
                 .help = "Multiplies every resolution: the fraction of Q_opt in chapter 6.",
                 .origin = "thesis, section 6.3",
                 .order = 2});
}

/// Everything of one variable but the strides. `tiles` ← tiles of a tiling along it, displaced ones included.
Result<TileCoder::Dimension> TileCoder::layOut(const StateVariable& v, double tilesPerUnit, int n, double& tiles) {
  Dimension dim;
  dim.scale = tilesPerUnit * n;
  dim.wraps = v.period.has_value();
  if (!dim.wraps) {
    dim.low = std::floor(v.low * dim.scale);
    dim.high = std::floor(v.high * dim.scale);
    dim.origin = std::floor(dim.low / n) * n;
    dim.cycle = static_cast<Index>(n);
    tiles = std::floor((dim.high - dim.origin + n - 1) / n) + 1;
    return dim;
  }
  const double wanted = tilesPerUnit * *v.period;
  tiles = std::round(wanted);
  if (tiles < 1 || tiles > kMostWeights || std::abs(tiles - wanted) > 1e-9 * tiles)
    return Error{fmt::format("features.{}: {} tiles in one turn of the {}; a variable that wraps needs a whole number.",
                             v.key, wanted, v.title)};
  dim.cycle = static_cast<Index>(tiles) * static_cast<Index>(n);
  dim.scale = tiles * n / *v.period;
  return dim;
}

Result<TileCoder> TileCoder::create(const Task& task, const Settings& settings) {
  TileCoder coder;
  const int n = coder.tilings_ = settings.tilings;
  double stride = 1.0;  // tiles of a tiling along the dimensions so far
  for (std::size_t d = 0; d < task.state.size(); ++d) {
    const StateVariable& v = task.state[d];
    double tiles = 0.0;
    Result<Dimension> dim = layOut(v, settings.resolution[d] * settings.scale / v.span, n, tiles);
    if (!dim) return dim.error();
    const double weights = stride * tiles * n * static_cast<double>(task.actions.size());
    if (weights > kMostWeights)
      return Error{
          fmt::format("features.{}: {} tilings with features.scale = {} need a table of {:.3g} weights; at most {:.3g} "
                      "are allowed, "
                      "so take fewer tilings, fewer tiles or a smaller scale.",
                      v.key, n, settings.scale, weights, kMostWeights)};
    dim->cycleStride = dim->wraps ? 0 : static_cast<Index>(stride);
    for (Index position = 0; position < dim->cycle; ++position)
      for (int i = 0; i < n; ++i) {
        const auto displacement = static_cast<Index>(i * (2 * static_cast<int>(d) + 1) % n);
        Index tile = (position + displacement) / static_cast<Index>(n);
        if (dim->wraps) tile %= static_cast<Index>(tiles);
        dim->carry.push_back(tile * static_cast<Index>(stride));
      }
    coder.dimensions_.push_back(std::move(*dim));
    stride *= tiles;
  }
  for (int i = 0; i < n; ++i) coder.tilingStart_.push_back(static_cast<Index>(i) * static_cast<Index>(stride));
  coder.size_ = static_cast<Index>(stride) * static_cast<Index>(n);
  return coder;
}

bool TileCoder::activeFeatures(std::span<const double> state, std::span<Index> out) const {
  const auto n = static_cast<std::size_t>(tilings_);
  bool inside = true;
  Index base = 0;
  for (std::size_t i = 0; i < n; ++i) out[i] = tilingStart_[i];
  for (std::size_t d = 0; d < dimensions_.size(); ++d) {
    const Dimension& dim = dimensions_[d];
    double step = std::floor(state[d] * dim.scale);
    Index position = 0;
    if (dim.wraps) {
      if (!std::isfinite(step)) step = 0, inside = false;
      step -= std::floor(step / dim.cycle) * dim.cycle;
      position = static_cast<Index>(step);
    } else {
      if (!(step >= dim.low)) step = dim.low, inside = false;  // NaN too
      if (step > dim.high) step = dim.high, inside = false;
      position = static_cast<Index>(step - dim.origin);
    }
    base += position / dim.cycle * dim.cycleStride;
    const Index* carry = &dim.carry[position % dim.cycle * n];
    for (std::size_t i = 0; i < n; ++i) out[i] += carry[i];
  }
  for (std::size_t i = 0; i < n; ++i) out[i] += base;
  return inside;
}

}  // namespace surefoot
