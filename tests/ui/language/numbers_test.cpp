// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/language/numbers.h"

#include <gtest/gtest.h>

#include "core/text/number_text.h"
#include "tests/ui/language/spoken.h"

namespace surefoot {

TEST(LocalNumbers, AreAsTheCoreWritesThemInEnglish) {
  EXPECT_EQ(countNumber(-1234567).toStdString(), "−1,234,567");
  EXPECT_EQ(fixedNumber(3.14159, 2).toStdString(), "3.14");
  EXPECT_EQ(typedNumber("1,234.5"), "1,234.5");
}

TEST(LocalNumbers, HaveACommaInDutchAndGerman) {
  for (const char* code : {"nl", "de"}) {
    const Spoken spoken(code);
    EXPECT_EQ(countNumber(-1234567).toStdString(), "−1\u202f234\u202f567");
    EXPECT_EQ(fixedNumber(3.14159, 2).toStdString(), "3,14");
    EXPECT_EQ(localNumbers(std::string("−45.0 (−55.1 … −32.0), p < .01, 1,000.5 s.")).toStdString(),
              "−45,0 (−55,1 … −32,0), p < .01, 1\u202f000,5 s.");
  }
}

TEST(TypedNumbers, TakeACommaAndAPoint) {
  const Spoken spoken("de");
  const auto value = [](const char* text) {
    const NumberText number = readNumberText(typedNumber(QString::fromUtf8(text)));
    return number.good ? number.value : std::nan("");
  };
  EXPECT_EQ(value("0,5"), 0.5);
  EXPECT_EQ(value("0.5"), 0.5);
  EXPECT_EQ(value("−12,25"), -12.25);
  EXPECT_EQ(value("1,000"), 1.0);
  EXPECT_EQ(value("0.005"), 0.005);
  EXPECT_EQ(value("1e-3"), 1e-3);
  EXPECT_EQ(value("1\u202f234,5"), 1234.5);
  EXPECT_EQ(value("1.234,5"), 1234.5);
  EXPECT_EQ(value("1.234.567"), 1234567);
  EXPECT_EQ(value("2 · 10⁻⁶"), 2e-6);
}

TEST(TypedNumbers, OfTwoMeaningsAreRefusedAndBothAreNamed) {
  const Spoken spoken("de");
  const NumberText number = readNumberText(typedNumber("1.250"));
  EXPECT_FALSE(number.good);
  EXPECT_EQ(number.readings, (std::vector<std::string>{"1250.0", "1.2500"}));
  EXPECT_FALSE(readNumberText(typedNumber("1,234.5")).good);
  EXPECT_FALSE(readNumberText(typedNumber("words")).good);
}

TEST(TypedNumbers, OfAListStandApartBySemicolonsOrBlanks) {
  const Spoken spoken("nl");
  for (const char* text : {"0,1; 0,25; 3", "0,1 0,25 3", "0.1, 0.25, 3"}) {
    const auto numbers = parseNumbers("list", typedNumbers(text));
    ASSERT_TRUE(numbers) << numbers.error().message;
    EXPECT_EQ(*numbers, (std::vector<double>{0.1, 0.25, 3.0})) << text;
  }
  EXPECT_EQ(typedNumbers("0..0,2:9"), "0..0.2:9");
}

}  // namespace surefoot
