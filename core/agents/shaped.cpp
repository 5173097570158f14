// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/shaped.h"

namespace surefoot {

void ShapingSettings::declare(Fields& f) {
  f.choice(kind, {.key = "rewards",
                  .title = "Reward shaping",
                  .label = "Shaping",
                  .when = When::NewTable,
                  .group = Group::Learning,
                  .help = "Adds the change of a coarse value function to the reward; it learns from these rewards.",
                  .origin = "thesis, section 6.1.3",
                  .choices = {"off", "all", "losses", "gains"},
                  .order = 3});
  f.real(discount, {.key = "discount",
                    .title = "Shaping discount",
                    .label = "V discount",
                    .symbol = "γ",
                    .low = 0.0,
                    .high = 1.0,
                    .sliderLow = 0.9,
                    .sliderHigh = 1.0,
                    .when = When::NewTable,
                    .group = Group::Learning,
                    .help = "The discount of the coarse value function V.",
                    .origin = "ours: as the learner's",
                    .order = 3,
                    .needs = "rewards"});
  f.real(stepSize, {.key = "step_size",
                    .title = "Shaping step size",
                    .label = "V step size",
                    .symbol = "α",
                    .low = 0.0,
                    .high = 2.0,
                    .sliderLow = 0.0,
                    .sliderHigh = 1.0,
                    .when = When::NewTable,
                    .group = Group::Learning,
                    .help = "The step size of the coarse value function V.",
                    .origin = "ours: as the learner's",
                    .order = 3,
                    .needs = "rewards"});
}

}  // namespace surefoot
