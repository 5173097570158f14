// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/rule_of_thumb.h"

#include <gtest/gtest.h>

namespace surefoot {

// Thesis, section 4.3: n* 57.5 → 62.6 and 59.9 → 59.6. It prints 115.5 for n* 61 and a goal of 400; its own formula
// gives 116.6.
TEST(RuleOfThumb, GivesTheThesissNumbers) {
  EXPECT_NEAR(ruleOfThumb(0.98, 57.5, 200, 0), 62.6, 0.05);
  EXPECT_NEAR(ruleOfThumb(0.98, 59.9, 200, 0), 59.6, 0.05);
  EXPECT_NEAR(ruleOfThumb(0.98, 61, 400, 0), 116.6, 0.05);
}

// eq. 4.3 term by term for a whole number of transitions.
TEST(RuleOfThumb, AddsTheTimePenaltyOfEveryStep) {
  double sum = 0;
  for (int k = 1; k <= 40; ++k) sum += std::pow(0.98, k) * -0.5;
  EXPECT_NEAR(ruleOfThumb(0.98, 40, 200, -0.5), std::pow(0.98, 40) * 200 + sum, 1e-12);
  EXPECT_NEAR(ruleOfThumb(1.0, 40, 200, -0.5), 180, 1e-12);
}

}  // namespace surefoot
