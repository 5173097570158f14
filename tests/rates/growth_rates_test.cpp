// SPDX-License-Identifier: GPL-3.0-or-later
// Looking more than once: how often lives = "decided" is wrong. 2,000 plans of three comparisons a cell, at a level of
// 5 per cent, where a fault would show.
#include <cstdio>

#include "core/findings/growth.h"
#include "tests/rates/studies.h"

namespace surefoot {

namespace {

struct PlanOutcome {
  double anyDifferent = 0, anySame = 0, allDecided = 0, lives = 0;
};

/// Every plan has all lives it may ever want; the decisions look at as many as they would have lived.
PlanOutcome outcomeOf(const char* truth, Design design, const std::array<double, 3>& changes) {
  const PlanGrowth growth{.decided = DecidedLives{.atLeast = 20, .atMost = 100, .group = 20, .level = 0.05},
                          .search = {}};
  Random random(20261130);
  PlanOutcome sum;
  for (int i = 0; i < kStudies; ++i) {
    Study study(design, 100, random);
    std::vector<Evidence> all = {study.condition("a", 23)};
    for (const double change : changes)
      all.push_back(study.condition(std::to_string(all.size()), 23 * (1 + change / 100), "a"));
    int different = 0, same = 0, open = 0;
    for (const std::string& s : growthOf(growth, all).sentences) {
      different += s.find(": fewer") != std::string::npos || s.find(": more") != std::string::npos;
      same += s.find("the same") != std::string::npos;
      open += s.find("not decided") != std::string::npos;
      sum.lives += std::atof(s.c_str() + s.find(" after ") + 7) / 3 / kStudies;
    }
    sum.anyDifferent += (different > 0) * 1.0 / kStudies;
    sum.anySame += (same > 0) * 1.0 / kStudies;
    sum.allDecided += (open == 0) * 1.0 / kStudies;
  }
  std::printf("%-46s any different %5.1f %%, any the same %5.1f %%, all decided %5.1f %%, %.0f lives\n", truth,
              100 * sum.anyDifferent, 100 * sum.anySame, 100 * sum.allDecided, sum.lives);
  return sum;
}

}  // namespace

TEST(GrowthRates, LookingOftenDoesNotMakeErrorsMoreLikely) {
  for (const Design design : {Design::Lives, Design::OwnQFunctions}) {
    EXPECT_LE(outcomeOf("nothing differs", design, {0, 0, 0}).anyDifferent, 0.06);
    EXPECT_LE(outcomeOf("all at the margin (-15, -15, +15 %)", design, {-15, -15, 15}).anySame, 0.06);
  }
}

TEST(GrowthRates, WhatIsClearIsDecidedSoonAndTheRestLater) {
  const PlanOutcome clear = outcomeOf("clear (-60, -50, +80 %)", Design::OwnQFunctions, {-60, -50, 80});
  EXPECT_GT(clear.allDecided, 0.99);
  EXPECT_LT(clear.lives, 25);
  const PlanOutcome fine = outcomeOf("fine (-25, -25, +30 %)", Design::OwnQFunctions, {-25, -25, 30});
  EXPECT_GT(fine.lives, clear.lives);
  EXPECT_LT(fine.lives, 100);
}

}  // namespace surefoot
