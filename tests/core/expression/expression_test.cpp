// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/expression/expression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/expression/compile.h"

namespace surefoot {

namespace {

/// x and y, falls and episodes (not below 0), the flag touches, and observed(1) to observed(3).
class TestNames : public Vocabulary {
 public:
  explicit TestNames(bool chance = false) : chance_(chance) {}
  Result<Quantity> find(std::string_view name, std::optional<std::string_view> argument) const override {
    if (name == "observed") {
      if (!argument) return Error{"observed needs the number of a step: observed(1)."};
      if (*argument != "1" && *argument != "2" && *argument != "3") return Error{"there is no step of this number."};
      return Quantity{5 + (*argument)[0] - '1'};
    }
    if (name == "x") return Quantity{0};
    if (name == "y") return Quantity{1};
    if (name == "falls") return Quantity{2, ValueKind::Number, 0.0};
    if (name == "episodes") return Quantity{3, ValueKind::Number, 0.0};
    if (name == "foot.touches") return Quantity{4, ValueKind::Flag, 0.0, 1.0};
    return Error{};
  }
  std::vector<std::string> names() const override {
    return {"x", "y", "falls", "episodes", "foot.touches", "observed("};
  }
  bool chance() const override { return chance_; }

 private:
  bool chance_;
};

constexpr double kValues[] = {2.0, -0.5, 40.0, 200.0, 1.0, 11.0, 12.0, 13.0};

double valueOf(std::string_view text, ValueKind wanted = ValueKind::Flag) {
  const auto compiled = compile(text, wanted, TestNames());
  EXPECT_TRUE(compiled) << text << ": " << compiled.error().message;
  return compiled ? compiled->evaluate(kValues) : std::nan("");
}

std::string refusal(std::string_view text, ValueKind wanted = ValueKind::Flag) {
  const auto compiled = compile(text, wanted, TestNames());
  return compiled ? "" : compiled.error().message;
}

}  // namespace

TEST(Expression, ComputesAsItIsWritten) {
  const std::map<std::string, double> expected = {
      {"1 + 2 * 3", 7},
      {"(1 + 2) * 3", 9},
      {"8 - 3 - 2", 3},
      {"8 / 2 / 2", 2},
      {"-x^2", -4},
      {"2 * -x", -4},
      {"x^0", 1},
      {"x^3 + .5", 8.5},
      {"1.5e-3 * 1000", 1.5},
      {"x < y ? 1 : x > y ? 2 : 3", 2},
      {"foot.touches ? 10 : 20", 10},
      {"abs(y) + min(x, 1) + max(x, 3)", 4.5},
      {"sign(y) + sign(0) + sign(x)", 0},
      {"floor(-0.5) + round(-0.5) + round(2.5)", 1},
      {"sqrt(16) + square(3) + hypot(3, 4)", 18},
      {"clamp(x, 0, 1) + clamp(y, 0, 1) + clamp(0.25, 0, 1)", 1.25},
      {"wrap(7, 4)", -1},
      {"wrap(2, 4)", -2},
      {"wrap(-7.5, 4)", 0.5},
      {"observed(1) + observed(3)", 24},
      {"0.5 * (x > 1)", 0.5},
      {"cos(0) + sin(0) + exp(0)", 2},
  };
  for (const auto& [text, value] : expected) EXPECT_DOUBLE_EQ(valueOf(text), value) << text;
  EXPECT_NEAR(valueOf("sin(pi / 6)"), 0.5, 1e-15);
  EXPECT_TRUE(std::isinf(valueOf("1 / (x - 2)")));
}

TEST(Expression, ConditionsHoldOrDoNot) {
  for (const char* text : {"falls >= 40 and episodes == 200", "x > 3 || y < 0", "not x == 3", "!foot.touches or x != 3",
                           "x <= 2 && (y > 0 or y < 0)", "foot.touches"}) {
    EXPECT_EQ(valueOf(text, ValueKind::Condition), 1.0) << text;
  }
  for (const char* text : {"falls < 40", "x > 3 and y < 0", "not (x == 2)", "!foot.touches", "x < 1 or y > 1"})
    EXPECT_EQ(valueOf(text, ValueKind::Condition), 0.0) << text;
}

TEST(Expression, AConditionIsEvaluatedUpToWhatDecides) {
  const auto compiled = compile("x > 1 or uniform(0, 1) > 0.5", ValueKind::Condition, TestNames(true));
  ASSERT_TRUE(compiled);
  Random random(1), untouched(1);
  EXPECT_TRUE(compiled->holds(kValues, &random));
  EXPECT_EQ(random.state(), untouched.state());
}

TEST(Expression, ChanceIsDrawnFromTheRandomNumbersGiven) {
  EXPECT_NE(refusal("uniform(0, 1)").find("no chance"), std::string::npos);
  const auto compiled = compile("-uniform(2, 3)", ValueKind::Number, TestNames(true));
  ASSERT_TRUE(compiled);
  Random random(5), same(5);
  EXPECT_EQ(compiled->evaluate(kValues, &random), -same.uniform(2, 3));
}

TEST(Expression, WhatIsWrongIsToldWithItsPlace) {
  const std::map<std::string, std::string> expected = {
      {"fals > 3", "at character 1: there is no \"fals\"; did you mean falls."},
      {"x + ep", "at character 5: there is no \"ep\"."},
      {"observd(1)", "at character 1: there is no \"observd\"; did you mean observed(."},
      {"observed(9)", "at character 1: there is no step of this number."},
      {"x = 3", "at character 3: compare with ==."},
      {"1 < x < 3", "at character 7: comparisons do not chain; write a < b and b < c."},
      {"x ≥ 3", "at character 3: \"≥\" is written >= here."},
      {"2x", "at character 2: a number ends here; write 2 * x for twice x, and 0.5 with a point."},
      {"(x + 1", "at character 7: the parenthesis of (… is not closed."},
      {"min(x)", "at character 6: min takes 2 values with commas between them."},
      {"x > 1 ? 2", "at character 10: a condition with ? needs a second value, behind a colon."},
      {"x and y > 1", "at character 1: a condition is wanted, and this is a number; compare it with something."},
      {"x^0.5", "at character 3: the exponent is a whole number from 0 to 16."},
      {"", "at character 1: it ends too early; a number or a name is missing."},
      {"x +", "at character 4: it ends too early; a number or a name is missing."},
      {"1e999", "at character 1: this number is too large or too small."},
      {"x $ y", "at character 3: \"$ y\" means nothing here."},
      {"observed(\"1)", "at character 10: this quotation mark has no other."},
  };
  for (const auto& [text, sentence] : expected) EXPECT_EQ(refusal(text), sentence) << text;
  EXPECT_NE(refusal("falls + 1", ValueKind::Condition), "");
  EXPECT_NE(refusal("falls > 1", ValueKind::Number), "");
}

TEST(Expression, WhatCanNeverHoldIsRefused) {
  for (const char* text :
       {"falls < 0", "falls >= 5 and falls < 3", "abs(x) < 0", "1 > 2", "foot.touches > 1",
        "falls > 3 and x > 1 and falls <= 3", "square(x) + 1 < 1", "episodes == 3 and episodes == 4"})
    EXPECT_NE(refusal(text, ValueKind::Condition).find("can never hold"), std::string::npos) << text;
  for (const char* text :
       {"falls <= 0", "falls >= 5 or falls < 3", "falls > 3 and falls < 4", "falls >= 3 and falls <= 3",
        "(falls > 5 or x > 1) and falls < 3", "not falls < 0", "x^2 < 1", "x - x < 1"})
    EXPECT_EQ(refusal(text, ValueKind::Condition), "") << text;
}

// Every text that is not refused fits the stack of the evaluation and that of the program.
TEST(Expression, SizesAreLimited) {
  const auto repeated = [](const char* text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
  };
  EXPECT_NE(refusal(repeated("(", 900) + "x"), "");
  EXPECT_NE(refusal(repeated("-", 900) + "x"), "");
  EXPECT_NE(refusal(repeated("x<1?x:", 150) + "x"), "");
  EXPECT_NE(refusal(repeated("1+(", 40) + "x" + repeated(")", 40)), "");
  EXPECT_NE(refusal(repeated("x+", 400) + "x"), "") << "801 instructions";
  EXPECT_NE(refusal(repeated(" ", 1001)), "");
  EXPECT_EQ(refusal(repeated("(", 12) + "x" + repeated(")", 12)), "");
  EXPECT_EQ(valueOf(repeated("x+", 200) + "x"), 402.0);
}

TEST(Expression, TellsWhatItReads) {
  const auto compiled = compile("x > 1 ? observed(2) : x + falls", ValueKind::Number, TestNames());
  ASSERT_TRUE(compiled);
  EXPECT_EQ(compiled->variables(), (std::vector<int>{0, 2, 6}));
}

}  // namespace surefoot
