// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/tile_settings.h"

#include <fmt/format.h>

#include "core/features/resolution.h"

namespace surefoot {

TileSettings::TileSettings(const Task& task) : variables_(task.state), actionVariables_(task.actionVariables) {
  for (const ActionVariable& v : task.actionVariables) actionResolution.push_back(v.resolution);
  for (const StateVariable& v : task.state) {
    resolution.push_back(v.resolution);
    from.push_back(v.low);
    to.push_back(v.high);
  }
}

void TileSettings::declare(Fields& f) {
  f.integer(tilings, {.key = "tilings",
                      .title = "Tilings",
                      .low = 1,
                      .high = kMostTilings,
                      .sliderLow = 1,
                      .sliderHigh = 32,
                      .when = When::NewTable,
                      .group = Group::Representation,
                      .help = "Displaced grids that lie over each other; a power of two is best.",
                      .origin = "thesis, section 3.1.3"});
  constexpr std::size_t kFew = 5;  // more variables than that: the form has one row for all of them, their scale
  const bool many = variables_.size() > kFew;
  for (std::size_t d = 0; d < variables_.size(); ++d) {
    const StateVariable& v = variables_[d];
    Parameter tiles = resolutionParameter(
        v, fmt::format("Tiles per {} of the {}: few generalise far, many tell states apart.", v.spanText, v.title),
        "thesis, section 3.1.3");
    if (many) tiles.order = 3;
    f.real(resolution[d], tiles);
  }
  for (std::size_t j = 0; j < actionVariables_.size(); ++j) {
    const ActionVariable& v = actionVariables_[j];
    f.real(actionResolution[j],
           {.key = v.key,
            .title = capitalised(v.title),
            .symbol = v.symbol,
            .unit = "/" + v.unit,
            .low = 0.001,
            .high = 1000,
            .sliderLow = 0.05,
            .sliderHigh = 1,
            .when = When::NewTable,
            .group = Group::Representation,
            .help = fmt::format("Tiles per {} of the {}: few let near actions share more.", v.unit, v.title),
            .origin = "wcaarls/grl, addons/leosim",
            .order = many ? 3 : 2});
  }
  Parameter factor = factorParameter(
      "scale", "Scale", "Multiplies every resolution: the fraction of Q_opt in chapter 6.", "thesis, section 6.3");
  if (many) factor.order = 1;
  f.real(scale, factor);
  f.integer(memory, {.key = "memory",
                     .title = "Hashed tiles",
                     .low = 0,
                     .high = 1 << 27,
                     .sliderLow = 0,
                     .sliderHigh = 1 << 20,
                     .when = When::NewTable,
                     .group = Group::Representation,
                     .help = "Tiles that a hashed table of fixed size holds; 0: a dense table with room for all.",
                     .origin = "ours",
                     .order = 3});
  for (std::size_t d = 0; d < variables_.size(); ++d) {
    const StateVariable& v = variables_[d];
    if (v.period) continue;
    const auto edge = [&](double& member, const char* suffix, const char* word, const char* label) {
      f.real(member,
             {.key = v.key + suffix,
              .title = capitalised(v.title) + word,
              .label = shortLabel(label, v),
              .symbol = v.symbol,
              .unit = v.unit,
              .low = v.low,
              .high = v.high,
              .when = When::NewTable,
              .group = Group::Representation,
              .help = fmt::format("The tiles cover the {} from here to there; outside they are worth 0.", v.title),
              .origin = "ours (thesis, section 6.5)",
              .order = 3});
    };
    edge(from[d], "_from", ", from", "From");
    edge(to[d], "_to", ", to", "To");
  }
}

}  // namespace surefoot
