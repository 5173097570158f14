// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts on lives made by hand, whose means are known.
#include <cmath>

#include "core/recipes/thesis_verdicts.h"
#include "tests/core/recipes/claim_evidence.h"

namespace surefoot {

namespace {

const std::vector<Evidence> kEvidence = {
    condition("reference", 100),           condition("half", 50, "reference"),
    condition("same", 100.5, "reference"), condition("TRL 0", 80, "reference"),
    condition("TRL 50", 60, "reference"),  condition("wild", 100, "reference", 1.4)};

Judgement judged(const std::string& kind, nlohmann::json arguments) {
  const auto j =
      judge(kRegistry, {.id = "X1", .kind = kind, .says = "", .arguments = std::move(arguments)}, kEvidence, 1);
  EXPECT_TRUE(j) << j.error().message;
  return j ? *j : Judgement{};
}
Verdict verdict(const std::string& kind, nlohmann::json arguments) {
  return judged(kind, std::move(arguments)).verdict;
}
const Json kHalf = Json::array({"half"}), kSame = Json::array({"same"}), kWild = Json::array({"wild"});

}  // namespace

TEST(Claim, AValueAgreesIfTheIntervalReachesTheThesissNumberByATenth) {
  EXPECT_EQ(verdict("value", {{"thesis", 52}, {"conditions", kHalf}}), Verdict::Agrees);
  EXPECT_EQ(verdict("value", {{"thesis", 70}, {"conditions", kHalf}}), Verdict::Differs);
  EXPECT_EQ(verdict("value", {{"thesis", 70}, {"tolerance", 0.3}, {"conditions", kHalf}}), Verdict::Agrees);
  EXPECT_EQ(verdict("value", {{"thesis", 60}, {"within", 2}, {"conditions", kHalf}}), Verdict::Differs);
  const Judgement j = judged("value", {{"thesis", 52}, {"conditions", kHalf}});
  EXPECT_NEAR(*j.ours, 50, 1e-9);
  EXPECT_LT(*j.low, 50);
  EXPECT_GT(*j.high, 50);
}

TEST(Claim, AReductionNeedsSignSignificanceAndSize) {
  EXPECT_EQ(verdict("reduction", {{"thesis", -45}, {"conditions", kHalf}}), Verdict::Agrees);
  EXPECT_EQ(verdict("reduction", {{"thesis", 45}, {"conditions", kHalf}}), Verdict::Differs);
  EXPECT_EQ(verdict("reduction", {{"thesis", 80}, {"at_least", 45}, {"conditions", kHalf}}), Verdict::Differs)
      << "large enough, in the other direction";
  EXPECT_EQ(verdict("reduction", {{"thesis", -5}, {"conditions", kSame}}), Verdict::Differs) << "not significant";
  const Judgement size = judged("reduction", {{"thesis", -80}, {"conditions", kHalf}});
  EXPECT_EQ(size.verdict, Verdict::Differs);
  EXPECT_EQ(size.note, "direction and significance agree, size differs");
  EXPECT_NEAR(*size.ours, -50, 1e-9);
  EXPECT_EQ(verdict("reduction", {{"thesis", -80}, {"at_least", 45}, {"conditions", kHalf}}), Verdict::Agrees);
}

TEST(Claim, SignificantAndNoDifferenceAreOppositesExceptWhereLivesAreTooFew) {
  EXPECT_EQ(verdict("significant", {{"conditions", kHalf}}), Verdict::Agrees);
  EXPECT_EQ(verdict("significant", {{"conditions", {"half", "same"}}}), Verdict::Differs);
  EXPECT_EQ(verdict("significant", {{"sign", 1}, {"conditions", kHalf}}), Verdict::Differs);
  EXPECT_EQ(verdict("no-difference", {{"conditions", kSame}}), Verdict::Agrees);
  EXPECT_EQ(verdict("no-difference", {{"conditions", {"half", "same"}}}), Verdict::Differs);
  EXPECT_EQ(verdict("no-difference", {{"conditions", kWild}}), Verdict::Undecided);
}

TEST(Claim, AnOrderHoldsInNearlyAllResamples) {
  EXPECT_EQ(verdict("order", {{"conditions", {"half", "TRL 0", "reference"}}}), Verdict::Agrees);
  EXPECT_EQ(verdict("order", {{"conditions", {"reference", "TRL 0", "half"}}}), Verdict::Differs);
  EXPECT_EQ(verdict("order", {{"conditions", {"reference", "same"}}}), Verdict::Undecided);
  EXPECT_EQ(verdict("lowest", {{"conditions", {"half", "TRL *", "reference"}}}), Verdict::Agrees);
  EXPECT_EQ(verdict("lowest", {{"conditions", {"TRL 0", "TRL 50"}}}), Verdict::Differs);
  EXPECT_EQ(verdict("pairs", {{"pairs", pairs({{"half", "reference"}, {"TRL 50", "TRL 0"}})}}), Verdict::Agrees);
  EXPECT_EQ(verdict("pairs", {{"pairs", pairs({{"half", "reference"}, {"TRL 0", "TRL 50"}})}}), Verdict::Differs);
  EXPECT_EQ(verdict("pairs", {{"pairs", pairs({{"half", "reference"}, {"same", "reference"}})}}), Verdict::Undecided);
}

TEST(Claim, WithinLivesNeedsMoreThanTheMean) {
  const auto verdictOf = [](double most) {  // the differences of lives lie between −10 and `most`
    Evidence e = condition("a", 100);
    for (std::size_t i = 0; i < e.lives.size(); ++i) e.lives[i].during = {100, i % 2 == 0 ? 90 : 100 + most};
    const auto j = judge(
        kRegistry,
        {.id = "X1",
         .kind = "within-lives",
         .says = "",
         .arguments = {{"measure", "success_during"}, {"other", "failure_during"}, {"conditions", Json::array({"a"})}}},
        {e}, 1);
    EXPECT_TRUE(j) << j.error().message;
    return j->verdict;
  };
  EXPECT_EQ(verdictOf(12), Verdict::Undecided) << "the mean is 1, its interval reaches below 0";
  EXPECT_EQ(verdictOf(60), Verdict::Agrees);
}

TEST(Claim, NotLongerIsUndecidedWhereAQuarterMoreIsPossible) {
  const auto verdictOf = [](double scatter) {
    std::vector<Evidence> evidence = {condition("reference", 100), condition("a", 100, "reference")};
    for (Evidence& e : evidence)
      for (std::size_t i = 0; i < e.lives.size(); ++i)
        e.lives[i].minutes = 2 + scatter * (static_cast<double>(i % 5) - 2);
    const auto j = judge(
        kRegistry, {.id = "X1", .kind = "not-longer", .says = "", .arguments = {{"conditions", Json::array({"a"})}}},
        evidence, 1);
    EXPECT_TRUE(j) << j.error().message;
    return j->verdict;
  };
  EXPECT_EQ(verdictOf(0.1), Verdict::Agrees);
  EXPECT_EQ(verdictOf(0.8), Verdict::Undecided);
}

TEST(Claim, OtherKinds) {
  EXPECT_EQ(verdict("ratio", {{"low", 1.8}, {"high", 2.2}, {"conditions", {"reference", "half"}}}), Verdict::Agrees);
  EXPECT_EQ(verdict("ratio", {{"low", 2.5}, {"high", 3}, {"conditions", {"reference", "half"}}}), Verdict::Differs);
  EXPECT_EQ(verdict("extreme", {{"low", -52}, {"high", -28}, {"conditions", {"TRL *"}}}), Verdict::Agrees);
  EXPECT_EQ(verdict("extreme", {{"low", -20}, {"high", -5}, {"conditions", {"TRL *"}}}), Verdict::Differs);
  EXPECT_EQ(verdict("not-worse", {{"conditions", {"half", "TRL *"}}}), Verdict::Agrees);
  EXPECT_EQ(verdict("not-worse", {{"conditions", {"TRL 0", "TRL 50"}}}), Verdict::Differs);
  EXPECT_EQ(verdict("not-worse", {{"conditions", {"same", "reference"}}}), Verdict::Agrees);
  EXPECT_EQ(verdict("below", {{"high", 60}, {"conditions", kHalf}}), Verdict::Agrees);
  EXPECT_EQ(verdict("below", {{"high", 40}, {"conditions", kHalf}}), Verdict::Differs);
  EXPECT_EQ(verdict("below", {{"high", 50}, {"conditions", kHalf}}), Verdict::Undecided);
  EXPECT_EQ(verdict("not-longer", {{"conditions", kHalf}}), Verdict::Agrees);
  EXPECT_EQ(verdict("not-longer", {{"reference", "half"}, {"conditions", {"TRL 0"}}}), Verdict::Differs);
  EXPECT_EQ(
      verdict("trend", {{"sign", 1}, {"along", "agent.step_size"}, {"conditions", {"half", "TRL *", "reference"}}}),
      Verdict::Agrees);
  EXPECT_EQ(verdict("trend", {{"sign", -1}, {"along", "agent.step_size"}, {"conditions", {"half", "TRL *"}}}),
            Verdict::Differs);
  EXPECT_EQ(
      verdict("within-lives", {{"measure", "success_during"}, {"other", "failure_during"}, {"conditions", {"*"}}}),
      Verdict::Agrees);
  EXPECT_EQ(
      verdict("within-lives", {{"measure", "failure_during"}, {"other", "success_during"}, {"conditions", {"*"}}}),
      Verdict::Differs);
  EXPECT_EQ(verdict("spread", {{"conditions", {"same", "reference"}}, {"others", {"TRL *"}}}), Verdict::Agrees);
  EXPECT_EQ(verdict("spread", {{"conditions", {"TRL *"}}, {"others", {"same", "reference"}}}), Verdict::Differs);
  EXPECT_EQ(verdict("settled", {{"high", 4}, {"conditions", kHalf}}), Verdict::Differs) << "never settled";
}

TEST(Claim, BestChoices) {
  const Json along = "agent.step_size";
  // The lowest of "TRL 0" (80) and "TRL 50" (60) is where the parameter is .6; of "half" and "reference" .5.
  const auto groups = [](const Json& a, const Json& b) { return Json::array({a, b}); };
  const Json low = {"half", "reference"}, high = {"TRL 0", "TRL 50"};
  const auto best = [&](const char* relation, const Json& a, const Json& b) {
    return verdict("best", {{"along", along}, {"relation", relation}, {"groups", groups(a, b)}});
  };
  EXPECT_EQ(best("lower", low, high), Verdict::Agrees);
  EXPECT_EQ(best("lower", high, low), Verdict::Differs);
  EXPECT_EQ(best("not-lower", high, low), Verdict::Agrees);
  EXPECT_EQ(best("not-lower", low, high), Verdict::Differs);
  EXPECT_EQ(best("same", low, high), Verdict::Differs);
  EXPECT_EQ(best("same", low, {"half", "same"}), Verdict::Agrees);
  EXPECT_NEAR(*judged("best", {{"along", along}, {"groups", groups(low, high)}}).ours, 0.5, 1e-12);

  const auto compromise = [&](const Json& conditions) {
    return verdict("compromise", {{"other", "minutes"}, {"conditions", conditions}});
  };
  EXPECT_EQ(compromise({"half", "TRL *"}), Verdict::Agrees);
  EXPECT_EQ(compromise({"TRL 0", "half"}), Verdict::Differs) << "half has fewer falls and is shorter";

  // Half falls by 50 with a spread of about 7 and 10, TRL 0 by 20.
  EXPECT_EQ(verdict("effect-order", {{"conditions", {"TRL 0", "half"}}}), Verdict::Agrees);
  EXPECT_EQ(verdict("effect-order", {{"conditions", {"half", "TRL 0"}}}), Verdict::Differs);
}

TEST(Claim, CoursesOfLearning) {
  // Lives whose rewards go from 50 to `lowest` and up again.
  const auto course = [](const std::string& name, double lowest) {
    Evidence e = condition(name, 10, "still");
    e.record.condition.stepTime = 0;
    for (int life = 0; life < 20; ++life) {
      auto& episodes = e.record.episodes.emplace_back();
      for (int k = 0; k < 400; ++k) {
        StoredEpisode episode;
        episode.transitions = 10;
        episode.reward = (k > 100 && k < 300 ? lowest : 50) + life % 5;
        episodes.push_back(episode);
      }
    }
    e.averages = meanAverageRewards(e.record);
    return e;
  };
  const std::vector<Evidence> evidence = {course("still", 50), course("dip", -20), course("rise", 90)};
  const auto verdictOf = [&](const std::string& kind, const char* name) {
    const auto j =
        judge(kRegistry, {.id = "X1", .kind = kind, .says = "", .arguments = {{"conditions", {name}}}}, evidence, 1);
    EXPECT_TRUE(j) << j.error().message;
    return j->verdict;
  };
  EXPECT_EQ(verdictOf("dips", "dip"), Verdict::Agrees);
  EXPECT_EQ(verdictOf("dips", "rise"), Verdict::Differs);
  EXPECT_EQ(verdictOf("bands-overlap", "dip"), Verdict::Differs);
  const auto same = judge(
      kRegistry,
      {.id = "X1", .kind = "bands-overlap", .says = "", .arguments = {{"reference", "dip"}, {"conditions", {"still"}}}},
      {course("dip", 50), course("still", 50)}, 1);
  EXPECT_EQ(same->verdict, Verdict::Agrees);
}

TEST(Claim, ExactOnes) {
  const auto row = [](Json r) { return Json::array({std::move(r)}); };
  const Json threeTimes = {{"condition", "TRL 0"}, {"key", "agent.step_size"}, {"over", "agent.step_size"},
                           {"of", "reference"},    {"expected", 0.8},          {"digits", 9}};
  EXPECT_EQ(verdict("parameters", {{"rows", row(threeTimes)}}), Verdict::Agrees);
  Json wrong = threeTimes;
  wrong["expected"] = 0.9;
  EXPECT_EQ(verdict("parameters", {{"rows", row(wrong)}}), Verdict::Differs);
}

TEST(Claim, AWrongClaimIsNamed) {
  const auto refused = [](const std::string& kind, Json arguments, const std::string& word) {
    const auto j =
        judge(kRegistry, {.id = "X1", .kind = kind, .says = "", .arguments = std::move(arguments)}, kEvidence, 1);
    ASSERT_FALSE(j) << kind;
    EXPECT_NE(j.error().message.find("X1"), std::string::npos) << j.error().message;
    EXPECT_NE(j.error().message.find(word), std::string::npos) << j.error().message;
  };
  refused("nonsense", {{"conditions", kHalf}}, "nonsense");
  refused("value", {{"conditions", kHalf}}, "thesis");
  refused("value", {{"thesis", "fifty"}, {"conditions", kHalf}}, "thesis");
  refused("value", {{"thesis", 50}, {"conditions", {"quarter"}}}, "quarter");
  refused("value", {{"thesis", 50}}, "conditions");
  refused("reduction", {{"thesis", 50}, {"conditions", {"reference"}}}, "reference");
  refused("pairs", {{"pairs", pairs({{"half", "nobody"}})}}, "pairs");
  refused("within-lives", {{"measure", "falls"}, {"other", "nothing"}, {"conditions", kHalf}}, "other");
  refused("trend", {{"sign", 1}, {"along", "policy.none"}, {"conditions", kHalf}}, "along");
  refused("best", {{"along", "agent.step_size"}, {"groups", pairs({{"half", "same"}})}}, "groups");
  refused("best", {{"along", "none"}, {"groups", pairs({{"half", "same"}, {"TRL 0", "TRL 50"}})}}, "along");
  refused("best", {{"along", "agent.step_size"}, {"relation", "odd"}, {"groups", pairs({{"TRL *"}, {"TRL *"}})}},
          "relation");
  refused("compromise", {{"conditions", kHalf}}, "other");
  refused("effect-order", {{"conditions", kHalf}}, "pairs");
  refused("parameters", {{"rows", Json::array({{{"condition", "nobody"}}})}}, "nobody");
  refused("parameters", {{"rows", Json::array()}}, "rows");
  refused("drawn", {{"draws", "bars"}, {"rows", Json::array({{{"condition", "half"}}})}}, "bars");
  refused("dips", {{"conditions", kHalf}}, "first");
  refused("same-values", {{"conditions", kHalf}}, "two");
  refused("ratio", {{"low", 1}, {"high", 2}, {"conditions", kHalf}}, "pairs");
  refused("equal-exploring", {{"conditions", kHalf}, {"others", kHalf}}, "others");
}

TEST(Claim, PatternsHaveStars) {
  EXPECT_TRUE(fits("pre(2): TRL 50", "pre(2): TRL *"));
  EXPECT_TRUE(fits("pre(2): TRL 50", "*TRL*0"));
  EXPECT_TRUE(fits("", "*"));
  EXPECT_FALSE(fits("pre(2): TRL 50", "pre(3): *"));
  EXPECT_FALSE(fits("TRL 50", "TRL 5"));
  EXPECT_FALSE(fits("ab", "ab*b")) << "what a star ends with is not what it began with";
  EXPECT_TRUE(fits("abcbc", "*bc"));
  std::string stars;
  for (int i = 0; i < 40; ++i) stars += "*a";
  EXPECT_FALSE(fits(std::string(80, 'a') + "b", stars + "c*")) << "and at once, however many stars";
}

TEST(ThesisVerdicts, AreOfSingleConditionsAndOfTheirFalls) {
  const std::vector<Claim> claims = {
      {.id = "A", .kind = "reduction", .says = "", .arguments = {{"conditions", kHalf}, {"thesis", -50}}},
      {.id = "B", .kind = "significant", .says = "", .arguments = {{"conditions", Json::array({"half", "same"})}}},
      {.id = "C", .kind = "no-difference", .says = "", .arguments = {{"conditions", kSame}}},
      {.id = "D",
       .kind = "value",
       .says = "",
       .arguments = {{"conditions", kWild}, {"thesis", 3}, {"measure", "minutes"}}},
      {.id = "E", .kind = "lowest", .says = "", .arguments = {{"conditions", Json::array({"half", "wild"})}}}};
  const auto verdicts = thesisVerdicts(kRegistry, claims, kEvidence, 1);
  ASSERT_EQ(verdicts.size(), 2u);
  EXPECT_EQ(verdicts.at("half").says, "−50 %");
  EXPECT_EQ(verdicts.at("half").verdict, Verdict::Agrees);
  EXPECT_EQ(verdicts.at("half").claims, (std::vector<std::string>{"A", "B"}));
  EXPECT_EQ(verdicts.at("same").verdict, Verdict::Differs) << "one says that it differs, and it does not";
}

}  // namespace surefoot
