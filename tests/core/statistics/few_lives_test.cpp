// SPDX-License-Identifier: GPL-3.0-or-later
// Claims that the lives cannot carry.
#include "tests/core/recipes/claim_evidence.h"

namespace surefoot {

TEST(FewLives, LivesThatAreTooFewLeaveItUndecided) {
  const auto along = [](const Json& a, const Json& b) { return Json::array({a, b}); };
  const Json both = {"b", "a"}, b = Json::array({"b"});
  const std::vector<std::pair<const char*, Json>> claims = {
      {"value", {{"thesis", 50}, {"conditions", b}}},
      {"value", {{"thesis", 90}, {"conditions", b}}},
      {"reduction", {{"thesis", -45}, {"conditions", b}}},
      {"reduction", {{"thesis", 45}, {"conditions", b}}},
      {"significant", {{"conditions", b}}},
      {"significant", {{"sign", 1}, {"conditions", b}}},
      {"no-difference", {{"conditions", b}}},
      {"order", {{"conditions", both}}},
      {"order", {{"conditions", {"a", "b"}}}},
      {"lowest", {{"conditions", both}}},
      {"pairs", {{"pairs", pairs({{"b", "a"}})}}},
      {"within-lives", {{"measure", "success_during"}, {"other", "failure_during"}, {"conditions", b}}},
      {"not-longer", {{"conditions", b}}},
      {"not-worse", {{"conditions", both}}},
      {"ratio", {{"low", 1.8}, {"high", 2.2}, {"conditions", {"a", "b"}}}},
      {"extreme", {{"low", -60}, {"high", -40}, {"conditions", b}}},
      {"below", {{"high", 60}, {"conditions", b}}},
      {"trend", {{"sign", 1}, {"along", "agent.step_size"}, {"conditions", {"a", "b", "c"}}}},
      {"settled", {{"high", 4}, {"conditions", b}}},
      {"pool", {{"conditions", b}}},
      {"spread", {{"conditions", both}, {"others", {"a", "c"}}}},
      {"best", {{"along", "agent.step_size"}, {"relation", "lower"}, {"groups", along(both, {"a", "c"})}}},
      {"compromise", {{"other", "minutes"}, {"conditions", both}}},
      {"effect-order", {{"conditions", {"c", "b"}}}},
      {"bands-overlap", {{"conditions", b}}}};
  for (const int lives : {1, 2}) {
    const std::vector<Evidence> few = {condition("a", 100, "", 1, lives), condition("b", 50, "a", 1, lives),
                                       condition("c", 80, "a", 1, lives)};
    for (const auto& [kind, arguments] : claims) {
      const auto j = judge(kRegistry, {.id = "X1", .kind = kind, .says = "", .arguments = arguments}, few, 1);
      ASSERT_TRUE(j) << kind << ": " << j.error().message;
      if (lives == 2 && std::string(kind) == "settled") continue;  // neither did
      EXPECT_EQ(j->verdict, Verdict::Undecided) << kind << " of " << lives;
      if (lives > 1) continue;
      EXPECT_NE(j->note.find("too few lives"), std::string::npos) << kind << ": " << j->note;
      EXPECT_FALSE(j->low || j->high || j->p) << kind;
    }
  }
}

TEST(FewLives, AFewQFunctionsDoNotShowThatTheyAreAlike) {
  const auto of = [](int qFunctions, int livesOfEach) {
    Evidence e = condition("a", 100, "", 0.3, qFunctions * livesOfEach);
    for (int i = 0; i < qFunctions * livesOfEach; ++i) {
      e.record.lives[static_cast<std::size_t>(i)].qFunction = i % qFunctions;
      e.lives[static_cast<std::size_t>(i)].falls = 100 + 10 * (i * 7 % 11);  // no more alike than any others
    }
    const Claim claim{.id = "X1", .kind = "pool", .says = "", .arguments = {{"conditions", {"a"}}}};
    const auto j = judge(kRegistry, claim, {e}, 1);
    return j ? j->verdict : Verdict::Differs;
  };
  EXPECT_EQ(of(3, 2), Verdict::Undecided);
  EXPECT_EQ(of(10, 11), Verdict::Agrees);
}

TEST(FewLives, OfAReferenceThatIsZeroThereAreNoPerCent) {
  const std::vector<Evidence> two = {condition("a", 0), condition("b", 5, "a")};
  const auto of = [&](const char* kind) {
    const Json arguments = {{"thesis", -45}, {"measure", "falls"}, {"conditions", {"b"}}};
    const auto j = judge(kRegistry, {.id = "X1", .kind = kind, .says = "", .arguments = arguments}, two, 1);
    EXPECT_TRUE(j);
    EXPECT_FALSE(j->ours);
    EXPECT_EQ(j->note.find("nan"), std::string::npos) << j->note;
    return *j;
  };
  EXPECT_EQ(of("reduction").verdict, Verdict::Undecided);
  EXPECT_NE(of("reduction").note.find("the reference is 0"), std::string::npos);
  EXPECT_EQ(of("not-longer").verdict, Verdict::Undecided);
  EXPECT_EQ(of("no-difference").verdict, Verdict::Differs) << "0 and 5 falls, whatever that is in per cent";
}

TEST(FewLives, WhatIsNotSignificantMayYetBeTrue) {
  const auto of = [&](double mean, double scatter) {
    const std::vector<Evidence> two = {condition("a", 100, "", scatter), condition("b", mean, "a", scatter)};
    const auto j = judge(
        kRegistry, {.id = "X1", .kind = "reduction", .says = "", .arguments = {{"thesis", -7}, {"conditions", {"b"}}}},
        two, 1);
    return j ? j->verdict : Verdict::Agrees;
  };
  EXPECT_EQ(of(94, 0.1), Verdict::Undecided) << "−6 %, and −7 is within the interval, but so is 0";
  EXPECT_EQ(of(90, 0.1), Verdict::Agrees);
  EXPECT_EQ(of(100.5, 0.1), Verdict::Differs);
  EXPECT_EQ(of(100.5, 1.0), Verdict::Undecided) << "the interval is wider than ± 25 %";
}

TEST(FewLives, AReductionThatTheIntervalReachesIsNotDenied) {
  const auto of = [](double mean, int lives, double atLeast) {
    const std::vector<Evidence> two = {condition("a", 100, "", 0.7, lives), condition("b", mean, "a", 0.7, lives)};
    const Json arguments = {{"thesis", -25}, {"at_least", atLeast}, {"conditions", {"b"}}};
    const auto j = judge(kRegistry, {.id = "X1", .kind = "reduction", .says = "", .arguments = arguments}, two, 1);
    return j ? j->verdict : Verdict::Agrees;
  };
  EXPECT_EQ(of(80, 3, 25), Verdict::Undecided) << "ours −20 and an interval from far below −25 to above 0";
  EXPECT_EQ(of(60, 400, 25), Verdict::Agrees);
  EXPECT_EQ(of(99, 4000, 25), Verdict::Differs) << "the interval does not reach it";
}

// Forty lives of five Q-functions, which carry all of the variance: the analysis of variance takes the lives for
// independent.
TEST(FewLives, LivesOfAFewQFunctionsDecideNothing) {
  const auto of = [](const char* name, const char* reference, double lowest, double step) {
    Evidence e = condition(name, 1, reference, 0, 40);
    e.pool = name;  // each its own
    for (std::size_t i = 0; i < e.lives.size(); ++i) {
      e.record.lives[i].qFunction = static_cast<int>(i % 5);
      e.lives[i].falls = e.lives[i].minutes = lowest + step * static_cast<double>(i % 5);
    }
    return e;
  };
  const std::vector<Evidence> open = {of("a", "", 60, 20), of("b", "a", 50, 10)};  // 100 and 70
  const std::vector<Evidence> clear = {of("a", "", 90, 5), of("b", "a", 60, 5)};   // 100 and 70, close together
  const auto b = Json::array({"b"}), both = Json::array({"a", "b"});
  const std::vector<std::tuple<const char*, Json, Verdict>> claims = {
      {"reduction", {{"thesis", -30}, {"conditions", b}}, Verdict::Agrees},
      {"significant", {{"conditions", b}}, Verdict::Agrees},
      {"no-difference", {{"conditions", b}}, Verdict::Differs},
      {"not-worse", {{"conditions", both}}, Verdict::Differs},
      {"compromise", {{"other", "minutes"}, {"conditions", both}}, Verdict::Differs}};
  for (const auto& [kind, arguments, verdict] : claims) {
    const Claim claim{.id = "X1", .kind = kind, .says = "", .arguments = arguments};
    const auto j = judge(kRegistry, claim, open, 1);
    ASSERT_TRUE(j) << j.error().message;
    EXPECT_EQ(j->verdict, Verdict::Undecided) << kind;
    EXPECT_FALSE(j->note.empty()) << kind << ": it is said why";
    EXPECT_GT(j->p.value_or(1), 0.01) << kind << ": of the means of the Q-functions, not of the lives";
    EXPECT_EQ(judge(kRegistry, claim, clear, 1)->verdict, verdict) << kind;
  }
}

TEST(FewLives, LivesThatNeverFallAreJudgedByTheDifference) {
  const std::vector<Evidence> two = {condition("a", 20, "", 0.1, 40), condition("b", 0, "a", 0, 40)};
  const auto of = [&](const char* kind, Json arguments) {
    arguments["conditions"] = {"b"};
    const auto j = judge(kRegistry, {.id = "X1", .kind = kind, .says = "", .arguments = arguments}, two, 1);
    EXPECT_TRUE(j);
    EXPECT_EQ(j->note.find("too few"), std::string::npos) << j->note;
    EXPECT_FALSE(j->low) << "how rare they are is not known";
    return *j;
  };
  EXPECT_EQ(of("reduction", {{"thesis", -100}}).verdict, Verdict::Agrees);
  EXPECT_EQ(of("reduction", {{"thesis", -25}, {"at_least", 25}}).verdict, Verdict::Agrees);
  EXPECT_EQ(of("reduction", {{"thesis", -45}}).verdict, Verdict::Differs);
  EXPECT_NE(of("reduction", {{"thesis", -45}}).note.find("0 in every life"), std::string::npos);
  EXPECT_EQ(of("significant", Json::object()).verdict, Verdict::Agrees);
  EXPECT_EQ(of("no-difference", Json::object()).verdict, Verdict::Differs);
  EXPECT_EQ(of("not-longer", {{"measure", "falls"}}).verdict, Verdict::Agrees);
}

TEST(FewLives, AConditionIsDrawnOnceHoweverOftenItIsNamed) {
  const std::vector<Evidence> two = {condition("a", 20), condition("b", 20.01, "a")};
  const Claim claim{
      .id = "X1", .kind = "spread", .says = "", .arguments = {{"conditions", {"a", "a"}}, {"others", {"a", "b"}}}};
  EXPECT_EQ(judge(kRegistry, claim, two, 1)->verdict, Verdict::Agrees) << "it has no distance from itself";
}

TEST(FewLives, TheFirstWithTheSameUnitsIsFoundWithoutComparingAll) {
  std::vector<Evidence> all;
  for (int i = 0; i < 60; ++i) {
    Evidence e = condition("c" + std::to_string(i), 10, "", 0.1, 4 + i % 3);
    e.record.paired = i % 2 == 0;
    e.pool = i % 5 < 3 ? "pool " + std::to_string(i % 5) : "";
    if (i % 5 < 4)
      for (std::size_t l = 0; l < e.lives.size(); ++l) e.record.lives[l].qFunction = static_cast<int>(l % 2);
    all.push_back(std::move(e));
  }
  FirstWithSameUnits firsts;
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::size_t first = 0;
    while (first < i && !sameUnits(all[first], all[i])) ++first;
    EXPECT_EQ(firsts.add(all[i]), first) << i;
  }
}

}  // namespace surefoot
