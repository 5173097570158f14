// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/robustness/value_list.h"

#include <gtest/gtest.h>

namespace surefoot {

namespace {

const Parameter kPush{.key = "--push", .unit = "N s", .low = -10, .high = 10};

std::vector<double> valuesIn(const std::string& text, const Parameter& parameter = kPush) {
  const auto values = parseValues(parameter, text);
  EXPECT_TRUE(values) << text << ": " << (values ? "" : values.error().message);
  return values ? *values : std::vector<double>{};
}

void expectRefused(const std::string& text, const std::string& words, const Parameter& parameter = kPush) {
  const auto values = parseValues(parameter, text);
  ASSERT_FALSE(values) << text;
  EXPECT_TRUE(values.error().message.starts_with(parameter.key)) << values.error().message;
  EXPECT_NE(values.error().message.find(words), std::string::npos) << values.error().message;
}

}  // namespace

TEST(ValueList, IsAListOrARange) {
  EXPECT_EQ(valuesIn("0;0.5;1"), (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(valuesIn("3"), (std::vector<double>{3}));
  EXPECT_EQ(valuesIn("0..2:5"), (std::vector<double>{0, 0.5, 1, 1.5, 2}));
  EXPECT_EQ(valuesIn("−1..1:3"), (std::vector<double>{-1, 0, 1}));
  EXPECT_EQ(valuesIn("1..-1:2"), (std::vector<double>{1, -1}));
  EXPECT_EQ(valuesIn("0..0.3:4"), (std::vector<double>{0, 0.1, 0.2, 0.3})) << "as if they were typed";
}

TEST(ValueList, TakesOnlyWhatTheParameterAllows) {
  const Parameter choice{
      .key = "environment.floor", .low = 0, .high = 1, .kind = Kind::Choice, .choices = {"flat", "rough"}};
  const Parameter whole{.key = "environment.substeps", .low = 1, .high = 9, .kind = Kind::Integer};
  EXPECT_EQ(valuesIn("flat;rough", choice), (std::vector<double>{0, 1}));
  EXPECT_EQ(valuesIn("1..5:3", whole), (std::vector<double>{1, 3, 5}));
  expectRefused("flat..rough:2", "no numbers", choice);
  expectRefused("flat;steep", "steep", choice);
  expectRefused("1..2:3", "1.5", whole);
  expectRefused("0;11", "11");
  expectRefused("0..11:2", "11");
}

TEST(ValueList, SaysWhatIsWrong) {
  expectRefused("0..2", "how many");
  expectRefused("0..2:1", "1");
  expectRefused("0..2:9999", "9999");
  expectRefused("2..2:3", "ends where it begins");
  expectRefused("0;1;0", "given twice");
  expectRefused("nan", "nan");
  expectRefused("0..inf:3", "inf");
  expectRefused("", "");
  expectRefused("..:", "");
}

TEST(ValueList, ASpanIsOneNumberOrTwo) {
  EXPECT_EQ(*parseSpan("--push-at", "0..5"), (std::pair{0.0, 5.0}));
  EXPECT_EQ(*parseSpan("--push-at", "2.5"), (std::pair{2.5, 2.5}));
  for (const char* bad : {"5..0", "", "..", "1..x", "nan"}) EXPECT_FALSE(parseSpan("--push-at", bad)) << bad;
}

}  // namespace surefoot
