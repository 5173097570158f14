// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/files/limited_json.h"
#include "core/files/limited_toml.h"

namespace surefoot {

namespace {

std::string times(int n, const std::string& text) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

}  // namespace

TEST(LimitedJson, WhatIsDeeperThanTheLimitIsDiscarded) {
  for (const int depth : {kDeepestJson, kDeepestJson + 1, 1'000'000}) {
    const bool allowed = depth <= kDeepestJson;
    EXPECT_EQ(parseJson(times(depth, "[") + times(depth, "]")).is_discarded(), !allowed) << depth;
    EXPECT_EQ(parseJson(times(depth, R"({"a":)") + "1" + times(depth, "}")).is_discarded(), !allowed) << depth;
  }
}

TEST(LimitedJson, BracketsInStringsAreText) {
  const std::string text = R"({"a": ")" + times(100, "[{") + R"(\"[[", "b": 1})";
  const nlohmann::json json = parseJson(text);
  ASSERT_TRUE(json.is_object());
  EXPECT_EQ(json["b"], 1);
}

TEST(LimitedJson, WhatIsNoJsonOrTooLongIsDiscarded) {
  for (const char* text : {"", "{", "nonsense", "{\"a\":1}}", "[1,]", "\"\xff\""})
    EXPECT_TRUE(parseJson(text).is_discarded()) << text;
  EXPECT_TRUE(parseJson("[1, 2]", 5).is_discarded());
  EXPECT_TRUE(parseJson("[1, 2]", 6).is_array());
}

TEST(LimitedToml, KeysOfTooManyPartsAreRefusedWithTheirLine) {
  const std::string allowed = times(kDeepestToml - 1, "a.") + "a = 1\n",
                    refused = times(kDeepestToml, "a.") + "a = 1\n";
  EXPECT_TRUE(checkTomlLimits(allowed + allowed));
  const Status s = checkTomlLimits("x = 1\n" + refused);
  ASSERT_FALSE(s);
  EXPECT_NE(s.error().message.find("line 2"), std::string::npos) << s.error().message;
  EXPECT_FALSE(checkTomlLimits("[" + times(100'000, "a.") + "a]\n"));
  EXPECT_FALSE(checkTomlLimits(times(100, "'a' . \"b\" . ") + "c = 1"));
}

TEST(LimitedToml, BracketsTooDeepAreRefused) {
  EXPECT_TRUE(checkTomlLimits("a = " + times(kDeepestToml, "[") + times(kDeepestToml, "]")));
  EXPECT_FALSE(checkTomlLimits("a = " + times(kDeepestToml + 1, "[") + times(kDeepestToml + 1, "]")));
  EXPECT_FALSE(checkTomlLimits("a = " + times(100, "{b=")));
}

TEST(LimitedToml, StringsCommentsAndNumbersAreNotCounted) {
  const std::string dots = times(100, "."), open = times(100, "[");
  for (const std::string& text : {"# " + dots + open + "\n", "a = \"" + dots + open + "\\\"" + open + "\"\n",
                                  "a = '" + dots + open + "'\n", "a = \"\"\"\n" + open + "\"\n" + dots + "\"\"\"\n",
                                  "a = '''\n" + open + "'\n'''\n", "a = [" + times(1000, "0.5,") + "]\n"})
    EXPECT_TRUE(checkTomlLimits(text)) << text;
}

TEST(LimitedToml, HugeTextsAreRefused) {
  EXPECT_FALSE(checkTomlLimits(std::string(kLongestToml + 1, '\n')));
}

}  // namespace surefoot
