// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/policies/threshold_restricted.h"

#include "core/policy.h"

namespace surefoot {

void ThresholdRestricted::Settings::declare(Fields& f) {
  threshold.declare(f,
                    {.key = "threshold",
                     .title = "Threshold",
                     .symbol = "",
                     .unit = "",
                     .low = -1e6,
                     .high = 1e6,
                     .sliderLow = -100,
                     .sliderHigh = 200,
                     .when = When::Now,
                     .group = Group::Policy,
                     .help = "An exploring step picks among the actions worth more than this.",
                     .origin = "thesis, section 4.2.1"},
                    true);
  exploration.declare(f);
  f.real(below, {.key = "below",
                 .title = "Share below",
                 .symbol = "",
                 .unit = "",
                 .low = 0.0,
                 .high = 1.0,
                 .sliderLow = 0.0,
                 .sliderHigh = 0.1,
                 .when = When::Now,
                 .group = Group::Policy,
                 .help = "Share of the exploring steps that pick an action below the threshold all the same.",
                 .origin = "thesis, section 4.2"});
}

void ThresholdRestricted::among(std::span<const double> q, std::span<double> pi) const {
  const double epsilon = settings_.exploration.epsilon.now();
  const double threshold = settings_.threshold.now();
  const auto n = static_cast<double>(q.size());
  int above = 0;
  for (const double value : q) above += value > threshold;

  double eachAbove = epsilon / n;
  double eachBelow = epsilon / n;
  if (above > 0 && above < static_cast<int>(q.size())) {
    eachAbove = epsilon * (1.0 - settings_.below) / above;
    eachBelow = epsilon * settings_.below / (n - above);
  }
  shareAmongGreedy(q, 1.0 - epsilon, pi);
  for (std::size_t a = 0; a < q.size(); ++a) pi[a] += q[a] > threshold ? eachAbove : eachBelow;
}

}  // namespace surefoot
