// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text.h"

#include <gtest/gtest.h>

namespace surefoot {

TEST(Text, NegativeNumbersHaveATrueMinusSign) {
  EXPECT_EQ(fixedText(-1.8, 2), "\u22121.80");
  EXPECT_EQ(fixedText(3.14159, 2), "3.14");
}

TEST(Text, ZeroIsNeverNegative) {
  EXPECT_EQ(fixedText(-0.001, 2), "0.00");
}

TEST(Text, ThousandsAreSeparated) {
  EXPECT_EQ(countText(999), "999");
  EXPECT_EQ(countText(1000), "1,000");
  EXPECT_EQ(countText(1234567), "1,234,567");
  EXPECT_EQ(countText(-1000), "\u22121,000");
}

}  // namespace surefoot
