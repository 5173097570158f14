// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text.h"

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

TEST(Text, ACellOfATableIsQuotedWhereItMustBe) {
  EXPECT_EQ(csvCell("TRL 50"), "TRL 50");
  EXPECT_EQ(csvCell("a, \"b\""), "\"a, \"\"b\"\"\"");
  EXPECT_EQ(csvCell("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csvCell(""), "");
}

TEST(Text, ACellIsNeverAFormula) {
  EXPECT_EQ(csvCell("=1+1"), "'=1+1");
  EXPECT_EQ(csvCell("=HYPERLINK(\"http://x\",\"y\")"), "\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\"");
  for (const char* begin : {"+", "-", "@", "\t", "\r", "\n", "＝"})
    EXPECT_NE(csvCell(begin + std::string("x")).find(std::string("'") + begin), std::string::npos) << begin;
  EXPECT_EQ(csvCell("a-1"), "a-1");
}

}  // namespace surefoot
