// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/rewinding.h"

#include <fmt/format.h>

#include "core/environment.h"

namespace surefoot {

void Rewinding::declare(Fields& f) {
  f.integer(steps, {.key = "rewind",
                    .title = "Steps back after a fall",
                    .label = "Back after a fall",
                    .symbol = "N",
                    .low = 0,
                    .high = kMost,
                    .sliderLow = 0,
                    .sliderHigh = 200,
                    .when = When::NextEpisode,
                    .group = Group::Learning,
                    .help = "After a fall the world goes back so many steps, and the episode goes on from there; it "
                            "counts as a rewind and not as a fall. For simulations; 0: a fall ends the episode.",
                    .origin = "ours: 0, as in the thesis",
                    .order = 3});
  f.integer(most, {.key = "rewinds",
                   .title = "Falls taken back in an episode, at most",
                   .label = "At most",
                   .low = 1,
                   .high = kMost,
                   .sliderLow = 1,
                   .sliderHigh = 20,
                   .when = When::NextEpisode,
                   .group = Group::Learning,
                   .help = "So many times an episode goes on after a fall; the fall after that ends it.",
                   .origin = "ours",
                   .order = 3,
                   .needs = "rewind"});
}

Status checkRewinding(const Parameters& parameters, const Environment& environment) {
  const Parameters::Entry* rewind = parameters.find("life.rewind");
  if (!rewind || rewind->value == 0.0 || environment.answersAtOnce()) return Done{};
  return Error{
      fmt::format("life.rewind = {}: a robot that a program moves cannot go back in time; it takes 0.", rewind->value)};
}

}  // namespace surefoot
