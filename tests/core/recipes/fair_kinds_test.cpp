// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of claims that make a comparison fair: at an equal share of exploring, with the choice accounted for, and not
// of lives that were cut off.
#include <fmt/format.h>

#include "tests/core/recipes/claim_evidence.h"

namespace surefoot {

namespace {

Evidence exploring(const std::string& name, double falls, double share) {
  Evidence e = condition(name, falls);
  for (LifeMeasures& life : e.lives) life.own.push_back({0, "exploring", share});
  return e;
}

Judgement judged(const std::vector<Evidence>& evidence, const std::string& kind, Json arguments) {
  const auto j =
      judge(kRegistry, {.id = "X1", .kind = kind, .says = "", .arguments = std::move(arguments)}, evidence, 1);
  EXPECT_TRUE(j) << j.error().message;
  return j ? *j : Judgement{};
}

}  // namespace

TEST(FairKinds, FallsAreComparedAtAnEqualShareOfExploring) {
  // On the line between ε .02 and ε .05 stand 22.5 falls at 3 %.
  const std::vector<Evidence> all = {exploring("greedy", 10, 0),       exploring("ε .02", 20, 0.02),
                                     exploring("ε .05", 27.5, 0.05),   exploring("less", 11, 0.03),
                                     exploring("as many", 22.5, 0.03), exploring("more", 40, 0.03),
                                     exploring("far away", 11, 0.2)};
  const auto of = [&](const char* name) {
    return judged(all, "equal-exploring", {{"conditions", {name}}, {"others", {"ε *", "greedy"}}});
  };
  EXPECT_EQ(of("less").verdict, Verdict::Agrees);
  EXPECT_NEAR(*of("less").ours, 100 * (11 / 22.5 - 1), 1e-9);
  EXPECT_EQ(of("as many").verdict, Verdict::Differs) << "no less than they";
  EXPECT_EQ(of("more").verdict, Verdict::Differs);
  EXPECT_EQ(of("far away").verdict, Verdict::Undecided);
  EXPECT_NE(of("far away").note.find("20.0 %"), std::string::npos) << of("far away").note;
}

TEST(FairKinds, EqualConditionsAreNoOrderAndNoContradictionOfOne) {
  const std::vector<Evidence> equal = {condition("a", 20), condition("b", 20), condition("c", 20), condition("d", 20)};
  for (const char* kind : {"lowest", "order"})
    EXPECT_EQ(judged(equal, kind, {{"conditions", {"a", "b", "c", "d"}}}).verdict, Verdict::Undecided) << kind;
  const std::vector<Evidence> last = {condition("a", 20), condition("b", 20), condition("c", 20), condition("d", 12)};
  EXPECT_EQ(judged(last, "lowest", {{"conditions", {"a", "b", "c", "d"}}}).verdict, Verdict::Differs);
  EXPECT_EQ(judged(last, "lowest", {{"conditions", {"d", "a", "b", "c"}}}).verdict, Verdict::Agrees);
  EXPECT_EQ(judged(last, "order", {{"conditions", {"a", "d"}}}).verdict, Verdict::Differs);
}

// Lives fall 10, 20, 30, 40 and 50 times in every row; what chooses knows it, knows nothing, or knows the reverse.
TEST(FairKinds, AChoiceIsHeldAgainstTheMeanOfItsRow) {
  Evidence real = condition("real", 30, "", 0.1, 100), trial = condition("trial", 30, "", 0.1, 100);
  const auto judgedBy = [&](auto look) {
    for (std::size_t i = 0; i < 100; ++i) {
      real.lives[i].falls = 10 + 10.0 * static_cast<double>((i + i / 5) % 5) + 0.01 * static_cast<double>(i % 7);
      trial.lives[i].allFalls = look(i, real.lives[i].falls);
    }
    return judged({real, trial}, "chosen",
                  {{"conditions", {"real"}}, {"by", {"trial"}}, {"measure", "falls"}, {"other", "all_falls"}});
  };
  const Judgement knows = judgedBy([](std::size_t, double falls) { return falls; });
  EXPECT_EQ(knows.verdict, Verdict::Agrees);
  EXPECT_NEAR(*knows.ours, 100 * (10.0 / 30 - 1), 0.5);
  EXPECT_EQ(judgedBy([](std::size_t, double falls) { return -falls; }).verdict, Verdict::Differs);
  EXPECT_NE(judgedBy([](std::size_t i, double) { return static_cast<double>(i * 37 % 11); }).verdict, Verdict::Agrees);
}

TEST(FairKinds, TheBestOfManyIsReportedFromOtherLivesThanChoseIt) {
  std::vector<Evidence> all = {condition("reference", 20)};
  for (int i = 0; i < 10; ++i) {  // all alike, but one is lucky in the half that chooses
    all.push_back(condition("TRL " + std::to_string(i), 20, "reference"));
    if (i == 3)
      for (std::size_t l = 0; l < all.back().lives.size(); l += 2) all.back().lives[l].falls *= 0.5;
  }
  const Judgement j = judged(all, "extreme", {{"low", -60}, {"high", -40}, {"conditions", {"TRL *"}}});
  EXPECT_EQ(j.verdict, Verdict::Differs);
  EXPECT_NEAR(*j.ours, 0, 1e-9);
  EXPECT_NE(j.note.find("TRL 3"), std::string::npos) << j.note;
}

TEST(FairKinds, LivesThatWereCutOffAreNotCompared) {
  std::vector<Evidence> all = {condition("reference", 20), condition("b", 10, "reference")};
  const auto verdict = [&](const char* kind, const char* measure, Json more) {
    more["measure"] = measure, more["conditions"] = {"b"};
    return judged(all, kind, std::move(more));
  };
  for (Evidence& e : all) e.record.condition.goalReward = 200, e.end = 500;
  EXPECT_EQ(verdict("significant", "falls", Json::object()).verdict, Verdict::Agrees);
  all[1].end.reset();
  for (const char* kind : {"significant", "not-longer", "no-difference"}) {
    const Judgement j = verdict(kind, "falls", Json::object());
    EXPECT_EQ(j.verdict, Verdict::Undecided) << kind;
    EXPECT_NE(j.note.find("never ended in b"), std::string::npos) << kind << ": " << j.note;
  }
  EXPECT_EQ(judged(all, "pairs", {{"pairs", pairs({{"b", "reference"}})}}).verdict, Verdict::Undecided);
  EXPECT_EQ(verdict("value", "falls", {{"thesis", 10}}).verdict, Verdict::Undecided);
  for (Evidence& e : all)
    for (std::size_t i = 0; i < e.lives.size(); ++i) e.lives[i].allFalls = e.lives[i].falls;
  EXPECT_EQ(verdict("significant", "all_falls", Json::object()).verdict, Verdict::Agrees) << "the whole life";
}

TEST(FairKinds, OfOneGroupTheBestValueIsTheThesissOrNot) {
  std::vector<Evidence> all = {condition("c 60", 60), condition("c 20", 20), condition("c 40", 40)};
  const auto verdict = [&](double thesis) {  // the parameter is a hundredth of the mean
    return judged(all, "best", {{"thesis", thesis}, {"along", "agent.step_size"}, {"groups", pairs({{"c *"}})}})
        .verdict;
  };
  EXPECT_EQ(verdict(0.2), Verdict::Agrees);
  EXPECT_EQ(verdict(0.4), Verdict::Differs);
  all = {condition("c 20", 20), condition("c 20.01", 20.01), condition("c 20.02", 20.02)};
  EXPECT_EQ(verdict(0.2001), Verdict::Undecided) << "any may be the best";
}

TEST(FairKinds, RatiosAndPairsOfTwoMeasures) {
  std::vector<Evidence> all = {condition("a", 20), condition("b", 10), condition("c", 30), condition("d", 15)};
  EXPECT_EQ(judged(all, "ratio", {{"low", 1.8}, {"high", 2.2}, {"conditions", {"a", "b", "c", "d"}}}).verdict,
            Verdict::Agrees);
  EXPECT_EQ(judged(all, "ratio", {{"low", 1.8}, {"high", 2.2}, {"conditions", {"a", "b", "a", "d"}}}).verdict,
            Verdict::Differs);
  const auto below = [&](const char* first, const char* second) {  // minutes are a fiftieth of falls
    return judged(all, "pairs", {{"measure", "minutes"}, {"other", "falls"}, {"pairs", pairs({{first, second}})}})
        .verdict;
  };
  EXPECT_EQ(below("a", "b"), Verdict::Agrees);
  EXPECT_EQ(judged(all, "pairs", {{"measure", "falls"}, {"other", "minutes"}, {"pairs", pairs({{"b", "a"}})}}).verdict,
            Verdict::Differs);
  // 20 to 10 is 10 apart and twofold, 300 to 250 is 50 apart and a fifth.
  all = {condition("x", 20), condition("y", 10), condition("u", 300), condition("v", 250)};
  Json spread = {{"conditions", {"u", "v"}}, {"others", {"x", "y"}}};
  EXPECT_EQ(judged(all, "spread", spread).verdict, Verdict::Differs);
  spread["relative"] = true;
  EXPECT_EQ(judged(all, "spread", spread).verdict, Verdict::Agrees);
}

TEST(FairKinds, OnManySystemsTheShareIsToldInWhichAClaimHolds) {
  const auto verdictWith = [](int holdsIn, int fails) {
    std::vector<Evidence> all;
    for (int s = 1; s <= 8; ++s) {
      const std::string system = "system " + std::to_string(s) + ": ";
      all.push_back(condition(system + "a", 20));
      all.push_back(condition(system + "b",
                              s <= holdsIn           ? 10
                              : s <= holdsIn + fails ? 40
                                                     : 20,
                              system + "a", s <= holdsIn + fails ? 0.1 : 0.9));
    }
    return judged(all, "significant", {{"conditions", {"b"}}});
  };
  EXPECT_EQ(verdictWith(6, 0).verdict, Verdict::Agrees);
  EXPECT_EQ(*verdictWith(6, 0).ours, 0.75);
  EXPECT_EQ(verdictWith(5, 1).verdict, Verdict::Undecided);
  EXPECT_EQ(verdictWith(5, 2).verdict, Verdict::Differs);
  EXPECT_NE(verdictWith(5, 2).note.find("not in 2 (6, 7)"), std::string::npos) << verdictWith(5, 2).note;
}

TEST(FairKinds, IndependentOptimaAddUpOrNot) {
  // Two parameters with values 1 and 2. Each alone is best at 2; together they are worst, or best.
  const auto grid = [](double both) {
    std::vector<Evidence> all;
    for (const auto& [a, b, falls] :
         {std::tuple(1.0, 1.0, 30.0), {2.0, 1.0, 20.0}, {1.0, 2.0, 20.0}, {2.0, 2.0, both}}) {
      all.push_back(condition(fmt::format("g {} {}", a, b), falls));
      all.back().configuration = {{"parameters", {{"x.a", a}, {"x.b", b}}}};
    }
    return judged(all, "adds-up", {{"conditions", {"g 1 1", "g *"}}, {"alongs", {"x.a", "x.b"}}});
  };
  EXPECT_EQ(grid(40).verdict, Verdict::Agrees);
  EXPECT_NE(grid(40).note.find("together: g 2 2"), std::string::npos) << grid(40).note;
  EXPECT_NEAR(*grid(40).ours, 100, 1e-9);
  EXPECT_EQ(grid(10).verdict, Verdict::Differs);
  EXPECT_EQ(grid(20.2).verdict, Verdict::Differs) << "one per cent worse than the best";
}

}  // namespace surefoot
