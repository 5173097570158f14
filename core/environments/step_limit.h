// SPDX-License-Identifier: GPL-3.0-or-later
// After how many steps an episode is cut off (truncated): for tasks whose episodes could go on for ever.
#pragma once

#include "core/basics/types.h"
#include "core/parameters.h"

namespace surefoot {

struct StepLimit {
  int most = 100000;
  int steps = 0;  ///< steps of the episode so far

  /// One more step; cuts the episode off if it has reached the limit and not ended by itself.
  void count(Outcome& outcome) {
    ++steps;
    if (outcome.ending == Ending::None && steps >= most) outcome.ending = Ending::Truncated;
  }
  void declare(Fields& f) {
    f.integer(most, {.key = "max_steps",
                     .title = "Step limit",
                     .low = 1,
                     .high = 1000000000,
                     .sliderLow = 100,
                     .sliderHigh = 100000,
                     .when = When::NextEpisode,
                     .group = Group::Model,
                     .help = "An episode is cut off after this many steps.",
                     .origin = "ours"});
  }
};

}  // namespace surefoot
