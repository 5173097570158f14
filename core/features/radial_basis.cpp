// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/radial_basis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/basics/portable_math.h"
#include "core/features/resolution.h"

namespace surefoot {

RadialBasis::Settings::Settings(const Task& task) : variables_(task.state) {
  for (const StateVariable& v : task.state) {
    resolution.push_back(v.resolution);
    width.push_back(v.span / v.resolution / 2);  // a tile is about two widths wide
  }
}

void RadialBasis::Settings::declare(Fields& f) {
  for (std::size_t d = 0; d < variables_.size(); ++d) {
    const StateVariable& v = variables_[d];
    f.real(resolution[d],
           resolutionParameter(v, fmt::format("Centres per {} of the {}.", v.spanText, v.title), "ours"));
    f.real(width[d],
           {.key = v.key + "_width",
            .title = capitalised(v.title) + ", width",
            .label = shortLabel("Width", v),
            .symbol = v.symbol,
            .unit = v.unit,
            .low = 1e-3 * v.span,
            .high = 10 * v.span,
            .sliderLow = 0.01 * v.span,
            .sliderHigh = v.span,
            .when = When::NewTable,
            .group = Group::Representation,
            .help = fmt::format("Width σ of the Gaussians along the {}: a wide one generalises far.", v.title),
            .origin = "ours: half a tile",
            .order = 2});
  }
  f.real(scale, factorParameter("scale", "Scale", "Multiplies every resolution: the fraction of Q_opt in chapter 6.",
                                "thesis, section 6.3"));
  f.real(widthScale,
         factorParameter("width", "Width", "Multiplies every width and leaves the centres where they are.", "ours"));
}

Result<RadialBasis::Dimension> RadialBasis::layOut(const StateVariable& v, const Settings& s, std::size_t d) {
  Dimension dim;
  dim.key = v.key;
  dim.wraps = v.period.has_value();
  dim.low = dim.first = v.low;
  dim.high = v.high;
  dim.spacing = v.span / (s.resolution[d] * s.scale);
  dim.width = s.width[d] * s.widthScale;
  double centres = std::ceil((v.high - v.low) / dim.spacing - 1e-9) + 1;
  if (dim.wraps) {
    centres = std::round(*v.period / dim.spacing);
    if (centres < 1 || std::abs(centres * dim.spacing - *v.period) > 1e-9 * *v.period)
      return Error{
          fmt::format("features.{}: {} centres in one turn of the {}; a variable that wraps needs a whole number.",
                      v.key, *v.period / dim.spacing, v.title)};
  } else {  // the same margin on both sides
    dim.first = (v.low + v.high - (centres - 1) * dim.spacing) / 2;
  }
  if (centres > kMostWeights) return Error{fmt::format("features.{}: {:.3g} centres are too many.", v.key, centres)};
  dim.centres = static_cast<int>(centres);
  const double block = 2 * std::ceil(kReach * dim.width / dim.spacing) + 1;
  dim.block = static_cast<int>(std::min(centres, block));
  return dim;
}

Result<RadialBasis> RadialBasis::create(const Task& task, const Settings& settings) {
  RadialBasis map;
  double centres = 1.0, active = 1.0;
  for (std::size_t d = 0; d < task.state.size(); ++d) {
    auto dim = layOut(task.state[d], settings, d);
    if (!dim) return dim.error();
    dim->stride = static_cast<Index>(centres);
    centres *= dim->centres;
    active *= dim->block;
    if (centres * static_cast<double>(task.actions.size()) > kMostWeights)
      return Error{
          fmt::format("features.{}: the grid has {:.3g} centres or more; take fewer, or a smaller "
                      "features.scale.",
                      dim->key, centres)};
    if (active > kMostActive)
      return Error{
          fmt::format("features.{}_width: {:.3g} centres would be on at once; at most {} are allowed, so take "
                      "smaller widths or fewer centres.",
                      dim->key, active, kMostActive)};
    map.dimensions_.push_back(std::move(*dim));
  }
  map.size_ = static_cast<Index>(centres);
  return map;
}

Cover RadialBasis::find(std::span<const double> state, Active& x) const {
  Cover cover = Cover::Inside;
  x.count = 1;
  x.index[0] = 0;
  x.value[0] = 1.0;
  for (std::size_t d = 0; d < dimensions_.size(); ++d) {
    const Dimension& dim = dimensions_[d];
    double s = state[d];
    if (!dim.wraps || !std::isfinite(s)) {
      if (!(s >= dim.low)) s = dim.low, cover = Cover::Edge;
      if (s > dim.high) s = dim.high, cover = Cover::Edge;
    }
    // The block of centres around s; at the edge of the grid it stays inside.
    const double nearest = std::round((s - dim.first) / dim.spacing);
    double begin = nearest - (dim.block - 1) / 2;
    if (!dim.wraps) begin = std::clamp(begin, 0.0, static_cast<double>(dim.centres - dim.block));

    std::array<double, kMostActive> g;
    std::array<Index, kMostActive> offset;
    double sum = 0.0;
    for (int k = 0; k < dim.block; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double t = (s - (dim.first + (begin + k) * dim.spacing)) / dim.width;
      sum += g[at] = portableExp(-0.5 * t * t);
      const double number = begin + k - std::floor((begin + k) / dim.centres) * dim.centres;  // wraps around
      offset[at] = static_cast<Index>(number) * dim.stride;
    }
    // x ← x ⊗ g/Σg. A state so far from every centre that all of g is 0 takes the nearest one.
    if (!(sum > 0.0)) g[static_cast<std::size_t>(std::clamp(nearest - begin, 0.0, dim.block - 1.0))] = sum = 1.0;
    using Values = Eigen::Map<Eigen::ArrayXd>;
    using Indices = Eigen::Map<Eigen::Array<Index, Eigen::Dynamic, 1>>;
    const int before = x.count;
    for (int k = dim.block - 1; k >= 0; --k) {  // the first block last: it is what the others are made from
      const auto at = static_cast<std::size_t>(k);
      Values(&x.value[at * static_cast<std::size_t>(before)], before) = Values(x.value.data(), before) * (g[at] / sum);
      Indices(&x.index[at * static_cast<std::size_t>(before)], before) = Indices(x.index.data(), before) + offset[at];
    }
    x.count = before * dim.block;
  }
  return cover;
}

nlohmann::json RadialBasis::layout() const {
  nlohmann::json variables = nlohmann::json::array();
  for (const Dimension& dim : dimensions_)
    variables.push_back({{"variable", dim.key},
                         {"first_centre", dim.first},
                         {"spacing", dim.spacing},
                         {"centres", dim.centres},
                         {"width", dim.width},
                         {"lowest", dim.low},
                         {"highest", dim.high},
                         {"block", dim.block},
                         {"wraps", dim.wraps}});
  return {{"kind", "radial-basis"}, {"variables", variables}};
}

std::vector<std::size_t> RadialBasis::shape() const {
  std::vector<std::size_t> shape;
  for (auto dim = dimensions_.rbegin(); dim != dimensions_.rend(); ++dim)
    shape.push_back(static_cast<std::size_t>(dim->centres));
  return shape;
}

}  // namespace surefoot
