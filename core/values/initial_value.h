// SPDX-License-Identifier: GPL-3.0-or-later
// The values before anything is learned.
#pragma once

#include "core/parameters.h"

namespace surefoot {

/// Range of the initial value of a state-action pair: every weight starts uniform in [low/n, high/n], n = Σ x the
/// number of active binary features, or 1 for normalised ones.
struct InitialValue {
  double low = 0.0;
  double high = 0.1;
  void declare(Fields& f) {
    f.real(low, {.key = "initial_low",
                 .title = "Initial Q, low",
                 .symbol = "",
                 .unit = "",
                 .low = -1e6,
                 .high = 1e6,
                 .sliderLow = -100,
                 .sliderHigh = 200,
                 .when = When::NewTable,
                 .group = Group::Representation,
                 .help = "Lowest value of a pair before anything is learned.",
                 .origin = "thesis, section 3.1.3",
                 .order = 3});
    f.real(high, {.key = "initial_high",
                  .title = "Initial Q",
                  .symbol = "",
                  .unit = "",
                  .low = -1e6,
                  .high = 1e6,
                  .sliderLow = 0,
                  .sliderHigh = 10,
                  .when = When::NewTable,
                  .group = Group::Representation,
                  .help = "Highest value of a pair before anything is learned.",
                  .origin = "thesis, section 3.1.3",
                  .order = 2});
  }
};

}  // namespace surefoot
