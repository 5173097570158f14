// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the intervals of counts (count_model.h) hold their 95 %, where falls are few and t intervals fail. 2,000
// studies a cell; the standard error of a cell is half a per cent. Of two falls in twenty lives they hold 91 %, and t
// intervals 83 %, which in one study of seven are not known at all.
#include <cstdio>

#include "tests/rates/studies.h"

namespace surefoot {

namespace {

struct Coverage {
  double ofCounts = 0, ofT = 0, unknownToT = 0, falsePositives = 0;
};

Coverage coverageOf(const char* what, Design design, double before, double after) {
  Random random(20261201);
  Coverage sum;
  for (int i = 0; i < kStudies; ++i) {
    Study study(design, 20, random);
    const Evidence a = study.condition("a", before), b = study.condition("b", after, "a");
    const auto counts = countsOf(a, b, "falls");
    const double truth = after / before;
    if (counts) sum.ofCounts += (counts->ratio.low <= truth && truth <= counts->ratio.high) * 1.0 / kStudies;
    if (counts) sum.falsePositives += (counts->p < 0.01) * 1.0 / kStudies;
    const Interval t = changeOf(estimateOf(a, "falls"), estimateOf(b, "falls"), sameUnits(a, b));
    sum.unknownToT += !t.known() * 1.0 / kStudies;
    sum.ofT += (t.known() && t.low <= 100 * (truth - 1) && 100 * (truth - 1) <= t.high) * 1.0 / kStudies;
  }
  std::printf("%-44s counts cover %5.1f %%, t %5.1f %% (unknown in %.1f %%), p < .01 in %.1f %%\n", what,
              100 * sum.ofCounts, 100 * sum.ofT, 100 * sum.unknownToT, 100 * sum.falsePositives);
  return sum;
}

}  // namespace

TEST(CountRates, HoldTheirShareWhereFallsAreFew) {
  const std::tuple<const char*, Design, double, double> cells[] = {
      {"2 to 1, lives", Design::Lives, 2, 1},
      {"2 to 1, own Q-functions", Design::OwnQFunctions, 2, 1},
      {"2 to 0.1, own Q-functions", Design::OwnQFunctions, 2, 0.1},
      {"20 to 10, own Q-functions", Design::OwnQFunctions, 20, 10}};
  for (const auto& [what, design, before, after] : cells) {
    const double covers = coverageOf(what, design, before, after).ofCounts;
    EXPECT_GT(covers, after < 1 ? 0.90 : 0.92) << what;
    EXPECT_LT(covers, 0.98) << what;
  }
  EXPECT_LT(coverageOf("2 to 2, own Q-functions", Design::OwnQFunctions, 2, 2).falsePositives, 0.018);
}

}  // namespace surefoot
