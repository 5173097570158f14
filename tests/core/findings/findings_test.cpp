// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of too few lives and of a reference without falls, in every form that leaves the program.
#include "core/findings/findings.h"

#include <gtest/gtest.h>

#include "core/findings/conditions_table.h"
#include "core/recipes/figure.h"
#include "core/registry.h"

namespace surefoot {

namespace {

Evidence evidenceOf(const std::string& name, const std::vector<double>& falls, bool paired = false) {
  Evidence e;
  e.record.condition.name = name;
  e.record.condition.reference = "a";
  e.record.condition.lives = static_cast<int>(falls.size());
  e.record.condition.stepTime = 0.05;
  e.record.paired = paired;
  e.configuration = nlohmann::json::object();
  for (const double f : falls) {
    StoredLife life;
    life.life = static_cast<int>(e.record.lives.size());
    e.record.lives.push_back(life);
    LifeMeasures measures;
    measures.falls = f;
    measures.minutes = 1 + f / 10;
    e.lives.push_back(measures);
    StoredEpisode episode;
    episode.transitions = 100;
    e.record.episodes.push_back(std::vector<StoredEpisode>(5, episode));
  }
  return e;
}

StoredPlan planOf(const std::vector<Evidence>& evidence) {
  StoredPlan plan;
  for (const Evidence& e : evidence) plan.conditions.push_back(e.record.condition);
  return plan;
}

/// As a reader of every kind sees it.
std::vector<std::string> everyForm(const std::vector<Evidence>& evidence) {
  const Findings findings = findingsOf(planOf(evidence), evidence);
  std::vector<std::string> forms = {findingsAsTable(findings), findingsAsJson(findings).dump(2),
                                    findingsAsCsv(findings), findingsAsLatex(findings)};
  for (const auto& row : conditionsTable(findings, evidence, {"minutes", "distance"}).rows)
    for (const std::string& cell : row) forms.push_back(cell);
  for (const char* kind : {"bars", "learning-curve", "cumulative-falls", "reward-against-falls"}) {
    FigureSpec spec;
    spec.name = spec.kind = kind;
    const auto figure = makeFigure(Registry(), spec, evidence);
    EXPECT_TRUE(figure);
    forms.push_back(figure ? figureAsCsv(*figure) : "");
  }
  return forms;
}

void expectNoOddNumbers(const std::vector<std::string>& forms) {
  for (const std::string& form : forms)
    for (const char* odd : {"nan", "inf", "NaN"}) EXPECT_EQ(form.find(odd), std::string::npos) << form;
}

}  // namespace

TEST(Findings, WhatRoundsToZeroHasNoSign) {
  Findings findings;
  Finding& f = findings.conditions.emplace_back();
  f.name = "a";
  f.comparison = Comparison{};
  f.comparison->change = {-0.04, -3.2, 0.02};
  for (const std::string& form : {findingsAsLatex(findings), findingsAsTable(findings)}) {
    EXPECT_EQ(form.find("-0.0"), std::string::npos) << form;
    EXPECT_EQ(form.find("+0.0"), std::string::npos) << form;
    EXPECT_NE(form.find("-3.2"), std::string::npos) << form;
  }
}

TEST(Findings, TwoLivesEachThatFallAlikeGiveNoP) {
  for (const bool paired : {false, true}) {
    const std::vector<Evidence> evidence = {evidenceOf("a", {1, 1}, paired), evidenceOf("b", {2, 2}, paired)};
    const auto json = findingsAsJson(findingsOf(planOf(evidence), evidence));
    for (const char* test : {"anova", "welch", "paired"})
      EXPECT_TRUE(json["conditions"][1]["against_reference"][test].is_null()) << test;
  }
  const std::vector<Evidence> pairs = {evidenceOf("a", {10, 12}, true), evidenceOf("b", {9, 11}, true)};
  EXPECT_EQ(changeText(*findingsOf(planOf(pairs), pairs).conditions[1].comparison, 1).find("-1.0"), std::string::npos);
  EXPECT_FALSE(findingsOf(planOf(pairs), pairs).conditions[1].comparison->difference.known());
}

TEST(Findings, OneLifeHasNoIntervalNoTestAndNoX) {
  const std::vector<Evidence> evidence = {evidenceOf("a", {20}), evidenceOf("b", {5})};
  const Findings findings = findingsOf(planOf(evidence), evidence);
  EXPECT_EQ(findings.conditions[1].falls.value, 5);
  EXPECT_FALSE(findings.conditions[1].falls.known());
  const Comparison& c = *findings.conditions[1].comparison;
  EXPECT_EQ(c.change.value, -75);
  EXPECT_FALSE(c.change.known());
  EXPECT_TRUE(std::isnan(c.p()));
  EXPECT_TRUE(std::isnan(c.holm));
  EXPECT_FALSE(c.significant());
  const auto json = findingsAsJson(findings)["conditions"][1];
  EXPECT_EQ(json["falls"]["value"], 5);
  EXPECT_TRUE(json["falls"]["low"].is_null());
  const auto against = json["against_reference"];
  for (const char* key : {"change_per_cent", "difference", "minutes_difference"}) {
    EXPECT_TRUE(against[key]["low"].is_null()) << key;
    EXPECT_TRUE(against[key]["high"].is_null()) << key;
  }
  for (const char* key : {"anova", "welch", "paired", "significant", "holm_p", "effect_size", "lives_needed"})
    EXPECT_TRUE(against[key].is_null()) << key;
  const std::string table = findingsAsTable(findings);
  EXPECT_NE(table.find("-75.0 "), std::string::npos) << table;
  EXPECT_EQ(table.find("±"), std::string::npos) << table;
  EXPECT_EQ(table.find(" X"), std::string::npos) << table;
  EXPECT_NE(findingsAsCsv(findings).find("b,a,1,,5,,,1.5,,,-75,,,,,,-15,,,"), std::string::npos)
      << findingsAsCsv(findings);
  EXPECT_EQ(findingsAsLatex(findings).find("\\pm"), std::string::npos);
  expectNoOddNumbers(everyForm(evidence));
}

TEST(Findings, OneLifeAgainstManyIsNotTestedEither) {
  const std::vector<Evidence> evidence = {evidenceOf("a", {20, 22, 18, 21}), evidenceOf("b", {5}),
                                          evidenceOf("c", {4, 5, 6, 5})};
  const Findings findings = findingsOf(planOf(evidence), evidence);
  EXPECT_FALSE(findings.conditions[1].comparison->anova);
  EXPECT_TRUE(findings.conditions[2].comparison->significant());
  EXPECT_EQ(findings.conditions[2].comparison->holm, findings.conditions[2].comparison->p()) << "one of one";
}

TEST(Findings, OfAReferenceWithoutFallsTheDifferenceIsTold) {
  const std::vector<Evidence> evidence = {evidenceOf("a", {0, 0, 0, 0}), evidenceOf("b", {2, 3, 1, 2}),
                                          evidenceOf("c", {0, 0, 0, 0})};
  const Findings findings = findingsOf(planOf(evidence), evidence);
  const Comparison& c = *findings.conditions[1].comparison;
  EXPECT_TRUE(std::isnan(c.change.value));
  EXPECT_EQ(c.difference.value, 2);
  EXPECT_NEAR(c.difference.low, 2 - 3.182446 * std::sqrt(2.0 / 3 / 4), 1e-5) << "t(.975, 3)";
  const std::string table = findingsAsTable(findings);
  EXPECT_NE(table.find("+2.0 falls (+0.7 … +3.3)"), std::string::npos) << table;
  EXPECT_NE(findingsAsLatex(findings).find("$+2.0$ falls ($+0.7$"), std::string::npos);
  const auto against = findingsAsJson(findings)["conditions"][1]["against_reference"];
  EXPECT_TRUE(against["change_per_cent"]["value"].is_null());
  EXPECT_EQ(against["difference"]["value"], 2);
  EXPECT_NE(findingsAsCsv(findings).find(",,,,"), std::string::npos);
  expectNoOddNumbers(everyForm(evidence));
}

TEST(Findings, PairsOfLivesAreNarrowerThanLives) {
  const std::vector<double> before = {10, 20, 30, 40, 50}, after = {9, 19, 29, 39, 49};
  const auto width = [&](bool paired) {
    const std::vector<Evidence> evidence = {evidenceOf("a", before, paired), evidenceOf("b", after, paired)};
    const Findings findings = findingsOf(planOf(evidence), evidence);
    const Comparison& c = *findings.conditions[1].comparison;
    EXPECT_EQ(c.paired.has_value(), paired);
    return c.difference.high - c.difference.low;
  };
  EXPECT_NEAR(width(true), 0, 1e-9);
  EXPECT_GT(width(false), 10);
}

TEST(Findings, LivesWithoutTheirPartnersAreNoPairs) {
  std::vector<Evidence> evidence = {evidenceOf("a", {10, 20, 30}, true), evidenceOf("b", {9, 19, 29}, true)};
  evidence[1].record.lives[2].life = 7;  // life 2 diverged
  EXPECT_FALSE(findingsOf(planOf(evidence), evidence).conditions[1].comparison->paired);
}

TEST(Findings, TheMeanOfAFewQFunctionsIsAsUncertainAsTheyAre) {
  Evidence e = evidenceOf("a", {10, 11, 12, 20, 21, 22, 30, 31, 32});
  const double alone = meanOf(e, "falls").high;
  for (StoredLife& l : e.record.lives) l.qFunction = l.life / 3;
  EXPECT_NEAR(meanOf(e, "falls").high, meanInterval(std::vector<double>{11, 21, 31})->high, 1e-9);
  EXPECT_GT(meanOf(e, "falls").high, alone + 5);
  EXPECT_EQ(meanOf(e, "minutes").high, findingsOf(planOf({e}), {e}).conditions[0].minutes.high);
}

}  // namespace surefoot
