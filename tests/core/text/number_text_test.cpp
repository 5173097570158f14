// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/number_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/basics/random.h"
#include "core/parameters.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

double read(const std::string& text, const std::string& unit = "") {
  const NumberText number = readNumberText(text, unit);
  EXPECT_TRUE(number.good) << text;
  return number.good ? number.value : std::nan("");
}

/// The sentence with which a text is refused, and these words in it.
void expectRefused(const std::string& text, const std::vector<std::string>& words) {
  const auto number = parseNumber("x", text);
  ASSERT_FALSE(number) << text << " is " << *number;
  for (const std::string& word : words)
    EXPECT_NE(number.error().message.find(word), std::string::npos) << number.error().message;
}

}  // namespace

TEST(NumberText, APersonsWaysOfWritingANumberAreRead) {
  EXPECT_EQ(read("12"), 12);
  EXPECT_EQ(read("+1.5"), 1.5);
  EXPECT_EQ(read("-1.5"), -1.5);
  EXPECT_EQ(read("\u22121.5"), -1.5) << "a true minus";
  EXPECT_EQ(read("1,000"), 1000);
  EXPECT_EQ(read("\u22121,234,567.25"), -1234567.25);
  EXPECT_EQ(read("1.000"), 1.0) << "the point is the decimal point";
  EXPECT_EQ(read("1e-06"), 1e-6);
  EXPECT_EQ(read("4.5e\u221204"), 4.5e-4);
  EXPECT_EQ(read("2 · 10⁻⁶"), 2e-6);
  EXPECT_EQ(read("2×10⁻⁶"), 2e-6);
  EXPECT_EQ(read("\u22121.5 · 10¹²"), -1.5e12);
  EXPECT_EQ(read("10^-3"), 1e-3);
  EXPECT_EQ(read("10⁻⁹"), 1e-9);
}

TEST(NumberText, TheUnitMayStandBehindIt) {
  EXPECT_EQ(read("9 min", "min"), 9);
  EXPECT_EQ(read("9min", "min"), 9);
  EXPECT_EQ(read("1,000 N m", "N m"), 1000);
  EXPECT_EQ(read("0.5\u00a0rad", "rad"), 0.5);
  expectRefused("9 min", {"not a finite"});
  EXPECT_FALSE(readNumberText("9 s", "min").good);
}

TEST(NumberText, WhatIsAmbiguousIsRefusedWithBothReadings) {
  expectRefused("1,5", {"\"1,5\"", "1.5", "15"});
  expectRefused("-0,05", {"-0.05", "-005"});
  expectRefused("1.000,5", {"1000.5", "1.0005"});
  expectRefused("1.234.567,8", {"1234567.8"});
  expectRefused("0,500", {"0.500", "0500"});
  expectRefused("1,0000", {"1.0000", "10000"});
  expectRefused("1 000", {"1000", "1; 000"});
}

TEST(NumberText, WhatIsNoNumberIsRefused) {
  for (const char* text :
       {"",     " 1",    "-",    "+-1", "--1", "1..2", "1.2.3", "1,,000", "1,000,00", ",5",    "nan",    "inf",
        "-inf", "1e999", "0x10", "1e",  "e5",  "1 2",  "ten",   "1_000",  "10⁻",      "x10⁻⁶", "5 10⁻⁶", "1,000.5,5"})
    EXPECT_FALSE(parseNumber("x", text)) << text;
}

TEST(NumberText, AListHasSemicolonsOrBlanksAndCommasWhereTheySayNothingElse) {
  const auto list = [](const std::string& text) {
    const auto numbers = parseNumbers("x", text);
    EXPECT_TRUE(numbers) << text << ": " << (numbers ? "" : numbers.error().message);
    return numbers ? *numbers : std::vector<double>();
  };
  const auto of = [](std::initializer_list<double> values) { return std::vector<double>(values); };
  EXPECT_EQ(list("0.1,0,0"), of({0.1, 0, 0}));
  EXPECT_EQ(list("1, 2, 3"), of({1, 2, 3}));
  EXPECT_EQ(list("-5,-1e6,1e6"), of({-5, -1e6, 1e6}));
  EXPECT_EQ(list("1,000; 2; \u22123,000.5"), of({1000, 2, -3000.5}));
  EXPECT_EQ(list("1,000 2 3"), of({1000, 2, 3}));
  EXPECT_EQ(list("0 50 100"), of({0, 50, 100}));
  EXPECT_EQ(list("0,100,50"), of({0, 100, 50})) << "no number of thousands begins with 0";
  EXPECT_EQ(list("0.25,125"), of({0.25, 125}));
  EXPECT_EQ(list("1,2000"), of({1, 2000}));
  EXPECT_EQ(list("7"), of({7}));
  for (const char* text : {"1,000", "5,100,3", "100,200", "1, 2,000", "0,5,250", "1,000,000"}) {
    const auto numbers = parseNumbers("--q", text);
    ASSERT_FALSE(numbers) << text;
    EXPECT_NE(numbers.error().message.find("separate the values"), std::string::npos) << numbers.error().message;
  }
  const std::string both = parseNumbers("--q", "1,000").error().message;
  EXPECT_NE(both.find("the number 1000"), std::string::npos) << both;
  EXPECT_NE(both.find("the list 1; 000"), std::string::npos) << both;
  EXPECT_NE(parseNumbers("--q", "1;1,5").error().message.find("value 2"), std::string::npos);
}

TEST(NumberText, WholeNumbersAreExactUpToTheLargestSeed) {
  constexpr auto kMost = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(*parseSeed("seed", std::to_string(kMost)), kMost);
  EXPECT_EQ(*parseSeed("seed", "18,446,744,073,709,551,615"), kMost);
  EXPECT_EQ(*parseSeed("seed", "9007199254740993"), 9007199254740993u);
  EXPECT_EQ(*parseWhole("n", "1,000", 1, 5000), 1000u);
  EXPECT_FALSE(parseWhole("n", "1e3", 1, 5000));
  for (const char* text : {"1.9", "-1", "18446744073709551616", "1,9", "", "1e30"})
    EXPECT_FALSE(parseSeed("seed", text)) << text;
  EXPECT_FALSE(parseWhole("n", "0", 1, 9));
}

// What the program prints it reads.
TEST(NumberText, EverythingThatIsPrintedIsReadBack) {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const double value = random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-4.0, 12.0));
    for (int decimals = 0; decimals < 5; ++decimals)
      EXPECT_NEAR(read(fixedText(value, decimals)), value,
                  0.51 * std::pow(10.0, -decimals) + 1e-3 * (std::abs(value) > 1e9));
    EXPECT_EQ(read(countText(value)), std::stod(fmt::format("{:.0f}", value)));
    EXPECT_EQ(read(fmt::format("{}", value)), value);
    EXPECT_EQ(read(formatValue(Parameter{}, value)), value);
    const double bound = std::stod(fmt::format("{:.3g}", value));
    EXPECT_NEAR(read(boundText(bound)), bound, 1e-12 * std::abs(bound) + 1e-12);
  }
  for (const double bound : {1e-9, -1e-9, 2.5e-8, 1e15, 3e20, -1e6, 1e6, 1e-6, 0.0, 134217728.0}) {
    EXPECT_EQ(read(boundText(bound)), bound) << boundText(bound);
  }
  EXPECT_EQ(boundText(-1e6), "\u22121,000,000");
  EXPECT_EQ(boundText(1e-6), "0.000001");
  EXPECT_EQ(boundText(1e-9), "10⁻⁹");
}

TEST(NumberText, AParameterTakesItAndSaysWhatElseItMayMean) {
  const Parameter threshold{.key = "policy.threshold", .unit = "N m", .low = -1e6, .high = 1e6};
  EXPECT_EQ(*parseValue(threshold, "\u22121,000 N m"), -1000);
  const std::string message = parseValue(threshold, "1,5").error().message;
  for (const char* word : {"policy.threshold", "1.5", "15", "\u22121,000,000 to 1,000,000"})
    EXPECT_NE(message.find(word), std::string::npos) << message;
}

}  // namespace surefoot
