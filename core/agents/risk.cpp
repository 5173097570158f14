// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/risk.h"

namespace surefoot {

void RiskSettings::declare(Fields& f) {
  f.choice(learn, {.key = "learn",
                   .title = "Risk of a fall",
                   .label = "Risk",
                   .when = When::NewTable,
                   .group = Group::Risk,
                   .help = "Learns how likely an action ends in a fall, beside its value.",
                   .origin = "ours: off, as in the thesis",
                   .choices = {"off", "on"}});
  f.real(discount, {.key = "discount",
                    .title = "Discount of risk",
                    .label = "ρ discount",
                    .symbol = "γ",
                    .low = 0.0,
                    .high = 1.0,
                    .sliderLow = 0.9,
                    .sliderHigh = 1.0,
                    .when = When::NewTable,
                    .group = Group::Risk,
                    .help = "What a fall one step later still counts; 1: all falls of the episode count.",
                    .origin = "ours: the probability of a fall in the episode",
                    .needs = "learn"});
  f.real(initial, {.key = "initial",
                   .title = "Initial risk",
                   .label = "ρ initial",
                   .low = 0.0,
                   .high = 1.0,
                   .when = When::NewTable,
                   .group = Group::Risk,
                   .help = "The risk of an action of which nothing is known.",
                   .origin = "ours",
                   .order = 3,
                   .needs = "learn"});
}

}  // namespace surefoot
