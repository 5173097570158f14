// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parameters.h"
#include "core/text/words.h"

#include <gtest/gtest.h>

namespace surefoot {

namespace {

enum class Colour : int { Red, Blue };

struct TestedSettings {
  double ratio = 0.25;
  int count = 3;
  Colour colour = Colour::Blue;
  void declare(Fields& f) {
    f.real(ratio, {.key = "ratio", .low = 0, .high = 1});
    f.integer(count, {.key = "count", .low = 1, .high = 8});
    f.choice(colour, {.key = "colour", .choices = {"red", "blue"}});
  }
};

Parameters parametersOf(TestedSettings& settings) {
  Fields fields("part.");
  settings.declare(fields);
  Parameters parameters;
  parameters.add(fields);
  return parameters;
}

}  // namespace

TEST(Parameters, TakeTheirDefaultsFromTheMembers) {
  TestedSettings settings;
  const Parameters parameters = parametersOf(settings);
  EXPECT_EQ(parameters.get("part.ratio"), 0.25);
  EXPECT_EQ(parameters.find("part.count")->parameter.fallback, 3);
  EXPECT_EQ(formatValue(parameters.find("part.colour")->parameter, parameters.get("part.colour")), "blue");
}

TEST(Parameters, ApplyWritesEveryValueIntoItsMember) {
  TestedSettings settings;
  Parameters parameters = parametersOf(settings);
  ASSERT_TRUE(parameters.set("part.ratio", std::string_view("0.5")));
  ASSERT_TRUE(parameters.set("part.count", std::string_view("8")));
  ASSERT_TRUE(parameters.set("part.colour", std::string_view("red")));
  TestedSettings other;
  Fields fields("part.");
  other.declare(fields);
  parameters.apply(fields);
  EXPECT_EQ(other.ratio, 0.5);
  EXPECT_EQ(other.count, 8);
  EXPECT_EQ(other.colour, Colour::Red);
}

TEST(Parameters, RefuseAValueOutOfRangeWithKeyValueAndRange) {
  TestedSettings settings;
  Parameters parameters = parametersOf(settings);
  const Status status = parameters.set("part.ratio", std::string_view("1.5"));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().message, "part.ratio: 1.5 is not allowed; it takes a number from 0 to 1.");
  EXPECT_EQ(parameters.get("part.ratio"), 0.25);
}

TEST(Parameters, RefuseWhatIsNoFiniteNumber) {
  TestedSettings settings;
  Parameters parameters = parametersOf(settings);
  for (const char* text : {"", " ", "nan", "inf", "-inf", "1e999", "0.5x", "0,5", "0x1", "+-1", "--1", " 1", "1 ", "½"})
    EXPECT_FALSE(parameters.set("part.ratio", std::string_view(text))) << text;
}

TEST(Parameters, AnIntegerTakesNoFraction) {
  TestedSettings settings;
  Parameters parameters = parametersOf(settings);
  EXPECT_FALSE(parameters.set("part.count", std::string_view("2.5")));
  EXPECT_FALSE(parameters.set("part.count", 2.5));
  EXPECT_TRUE(parameters.set("part.count", std::string_view("2")));
}

TEST(Parameters, AnUnknownKeyNamesTheNearestKnownOne) {
  TestedSettings settings;
  Parameters parameters = parametersOf(settings);
  const Status status = parameters.set("part.coulor", std::string_view("red"));
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().message.find("did you mean part.colour"), std::string::npos) << status.error().message;
}

TEST(NearestWord, FindsTheWordThatWasMeantAndNothingForNonsense) {
  EXPECT_EQ(nearestWord("temperatur", {"policy.temperature", "policy.epsilon"}), "policy.temperature");
  EXPECT_EQ(nearestWord("qqqqqqqqqqqqqq", {"trl", "softmax"}), "");
}

}  // namespace surefoot
