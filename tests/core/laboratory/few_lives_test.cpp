// SPDX-License-Identifier: GPL-3.0-or-later
// Claims that the lives cannot carry.
#include "tests/core/laboratory/claim_evidence.h"

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
    const auto j = judge(kRegistry,
                         {.id = "X1", .kind = "reduction", .says = "",
                          .arguments = {{"thesis", -7}, {"conditions", {"b"}}}},
                         two, 1);
    return j ? j->verdict : Verdict::Agrees;
  };
  EXPECT_EQ(of(94, 0.1), Verdict::Undecided) << "−6 %, and −7 is within the interval, but so is 0";
  EXPECT_EQ(of(90, 0.1), Verdict::Agrees);
  EXPECT_EQ(of(100.5, 0.1), Verdict::Differs);
  EXPECT_EQ(of(100.5, 1.0), Verdict::Undecided) << "the interval is wider than ± 25 %";
}

}  // namespace surefoot
