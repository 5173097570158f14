// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/td_control.h"

namespace surefoot {

void ControlSettings::declare(Fields& f) {
  f.real(discount, {.key = "discount",
                    .title = "Discount",
                    .symbol = "γ",
                    .low = 0.0,
                    .high = 1.0,
                    .sliderLow = 0.9,
                    .sliderHigh = 1.0,
                    .when = When::Now,
                    .group = Group::Learning,
                    .help = "What a reward one step later is still worth.",
                    .origin = "thesis, section 3.1.4"});
  if (dutch)
    traces.declareCutoff(f);
  else
    traces.declare(f);
}

}  // namespace surefoot
