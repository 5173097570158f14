// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/values/estimate.h"

namespace surefoot {

void EstimateSettings::declare(Fields& f) {
  stepSize.declare(f, {.key = "step_size",
                       .title = "Step size",
                       .symbol = "α",
                       .low = 0.0,
                       .high = 2.0,
                       .sliderLow = 0.0,
                       .sliderHigh = 1.0,
                       .when = When::Now,
                       .group = Group::Learning,
                       .help = "Share of the error that one update closes, over all tilings together.",
                       .origin = "thesis, section 3.1.4"});
  f.real(traceDecay, {.key = "trace_decay",
                      .title = "Trace decay",
                      .symbol = "λ",
                      .low = 0.0,
                      .high = 1.0,
                      .sliderLow = 0.0,
                      .sliderHigh = 1.0,
                      .when = When::Now,
                      .group = Group::Learning,
                      .help = "How far back along the way a surprise is felt; 0: one step.",
                      .origin = "thesis, section 3.1.4"});
  f.real(asymmetry, {.key = "asymmetry",
                     .title = "Asymmetry of errors",
                     .label = "Asymmetry",
                     .symbol = "κ",
                     .low = -0.999,
                     .high = 0.999,
                     .sliderLow = 0.0,
                     .sliderHigh = 0.2,
                     .when = When::Now,
                     .group = Group::Learning,
                     .help = "Errors below 0 count 1 + κ times, those above 1 − κ times: with κ > 0 it is risk-averse.",
                     .origin = "ours: 0, as in the thesis (Mihatsch & Neuneier 2002)",
                     .order = 3});
}

void TraceSettings::declareCutoff(Fields& f) {
  f.real(cutoff, {.key = "trace_cutoff",
                  .title = "Trace cut-off",
                  .low = 0.0,
                  .high = 1.0,
                  .sliderLow = 0.0,
                  .sliderHigh = 0.1,
                  .when = When::Now,
                  .group = Group::Learning,
                  .help = "A trace below this is forgotten.",
                  .origin = "ours",
                  .order = 2});
}

void TraceSettings::declare(Fields& f) {
  declareCutoff(f);
  f.choice(kind, {.key = "trace",
                  .title = "Trace",
                  .when = When::Now,
                  .group = Group::Learning,
                  .help = "A pair visited again: its trace is set to 1, or 1 is added.",
                  .origin = "thesis, section 2.2.2",
                  .choices = {"replacing", "accumulating"},
                  .order = 3});
  f.choice(otherActions, {.key = "trace_other_actions",
                          .title = "Other actions",
                          .when = When::Now,
                          .group = Group::Learning,
                          .help = "Traces of the actions not taken in a state visited again: kept, or cleared.",
                          .origin = "ours (Singh & Sutton 1996)",
                          .choices = {"keep", "clear"},
                          .order = 3});
}

}  // namespace surefoot
