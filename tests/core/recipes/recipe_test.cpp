// SPDX-License-Identifier: GPL-3.0-or-later
// What a recipe says wrongly is told when it is read, and nothing that it says ends the program.
#include "core/recipes/recipe.h"

#include "core/findings/findings.h"
#include "core/recipes/thesis_marks.h"
#include "core/recipes/thesis_verdicts.h"
#include "tests/core/recipes/claim_evidence.h"

namespace surefoot {

namespace {

const std::string kPlan = "[[condition]]\nname = \"a\"\nenvironment = \"cliff\"\nfeatures = \"table\"\nepisodes = 5\n";

std::string refusal(const std::string& more) {
  const auto recipe = parseRecipe(kRegistry, kPlan + more, "own.toml", {});
  return recipe ? "" : recipe.error().message;
}

void expectTold(const std::string& more, const std::vector<const char*>& words) {
  const std::string told = refusal(more);
  for (const char* word : words) EXPECT_NE(told.find(word), std::string::npos) << more << "\ntold: " << told;
}

}  // namespace

TEST(Recipe, AnArgumentOfAnotherTypeIsToldWithWhatIsExpected) {
  const std::string claim = "[[claim]]\nid = \"X\"\nkind = \"value\"\nconditions = [\"a\"]\nthesis = 5\n";
  EXPECT_EQ(refusal(claim), "");
  const std::string other = "[[claim]]\nid = \"X\"\nkind = \"value\"\n";
  expectTold(other + "measure = 3\n", {"own.toml", "claim X", "measure", "a text is expected, not 3"});
  expectTold(other + "conditions = [1]\n", {"claim X", "conditions", "a list of texts is expected, not [1]"});
  expectTold(other + "conditions = \"a\"\n", {"conditions", "a list of texts"});
  expectTold(other + "thesis = true\n", {"thesis", "a number or a text is expected, not true"});
  expectTold(other + "reference = 1\n", {"reference", "a text"});
  expectTold(other + "within = \"x\"\n", {"within", "a number is expected"});
  expectTold(other + "calibrated = \"yes\"\n", {"calibrated", "true or false"});
  expectTold(other + "pairs = [\"a\"]\n", {"pairs", "a list of lists of texts"});
  expectTold(other + "rows = [1]\n", {"rows", "a list of tables"});
  expectTold(claim + "measure = \"fals\"\n", {"claim X", "measure", "no \"fals\"", "falls"});
  expectTold(other + "conditions = [\"a\", \"c\"]\n", {"claim X", "conditions", "none is called \"c\""});
  expectTold(other + "q = [\"a\"]\n", {"q", "a list of numbers"});
  expectTold(other + "mesure = \"falls\"\n", {"claim X", "mesure", "did you mean measure"});
  expectTold("[[claim]]\nid = 3\nkind = \"value\"\n", {"id", "a text is expected, not 3"});
  expectTold("[[claim]]\nid = \"X\"\nkind = \"odd\"\n", {"claim X", "no kind \"odd\"", "reduction"});
  expectTold(claim + claim, {"an id of its own"});
}

TEST(Recipe, AFiguresArgumentsAreCheckedToo) {
  const std::string figure = "[[figure]]\nname = \"f\"\nkind = \"bars\"\n";
  EXPECT_EQ(refusal(figure), "");
  expectTold(figure + "measure = 3\n", {"figure f", "measure", "a text is expected, not 3"});
  expectTold(figure + "conditions = [1]\n", {"figure f", "conditions", "a list of texts"});
  expectTold(figure + "q = [\"x\"]\n", {"figure f", "q", "a list of numbers"});
  expectTold(figure + "colour = \"red\"\n", {"figure f", "colour"});
  expectTold(figure + "measure = \"fals\"\n", {"figure f", "measure", "no \"fals\"", "falls"});
  expectTold(figure + "conditions = [\"b*\"]\n", {"figure f", "conditions", "none is called \"b*\""});
  expectTold("[[figure]]\nname = \"f\"\nkind = \"learning-kurve\"\n", {"figure f", "kind", "learning-curve"});
  expectTold("[[figure]]\nname = \"a/b\"\n", {"a/b", "without a slash"});
  expectTold("[[figure]]\nkind = \"bars\"\n", {"a name is needed"});
  expectTold(figure + figure, {"figure f", "there are two of this name"});
}

// As a store made elsewhere may hold them; the claims as no reader lets them through.
TEST(Recipe, OddClaimsAndConfigurationsEndNothing) {
  std::vector<Evidence> evidence = {condition("a", 20), condition("b", 10, "a")};
  evidence[0].configuration = {
      {"policy", 3},
      {"agent", Json::array({1})},
      {"environment", 1.5},
      {"parameters",
       {{"agent.discount", "x"}, {"environment.goal_reward", true}, {"environment.time_reward", Json::array()}}}};
  evidence[1].configuration = Json::array({1, 2});
  std::vector<Claim> claims;
  for (const char* kind : {"value", "reduction", "significant", "no-difference", "trend", "best", "rule", "pairs",
                           "spread", "effect-order", "equal-exploring", "extreme", "lowest", "ratio"})
    for (const Json& odd : {Json(3), Json("a"), Json(true), Json::array({1}), Json::object(), Json(nullptr)})
      for (const char* key : {"measure", "conditions", "reference", "thesis", "groups", "rows", "along", "pairs",
                              "others", "other", "relative", "sign"}) {
        Json arguments = {{"conditions", Json::array({"b"})}, {"thesis", -45}};
        arguments[key] = odd;
        claims.push_back({.id = "X", .kind = kind, .says = "", .arguments = arguments});
      }
  for (const Claim& claim : claims) EXPECT_NO_THROW(static_cast<void>(judge(kRegistry, claim, evidence, 1)));
  EXPECT_NO_THROW(static_cast<void>(thesisVerdicts(kRegistry, claims, evidence, 1)));
  StoredPlan plan;
  for (const Evidence& e : evidence) plan.conditions.push_back(e.record.condition);
  EXPECT_NO_THROW(static_cast<void>(findingsOf(plan, evidence)));
  for (const char* kind : {"bars", "against", "settling"}) {
    FigureSpec spec;
    spec.name = spec.kind = kind;
    spec.along = "agent.discount";
    auto figure = makeFigure(kRegistry, spec, evidence);
    if (figure) {
      EXPECT_NO_THROW(markThesis(*figure, "falls", claims, evidence));
    }
  }
}

}  // namespace surefoot
