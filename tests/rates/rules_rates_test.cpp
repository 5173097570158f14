// SPDX-License-Identifier: GPL-3.0-or-later
// How often each rule of judging (claim.h) says agrees, differs or undecided: when the thesis is exactly right, when it
// is off by half, when it is wrong. 2,000 studies a cell; the standard error of a cell is at most 1.1 per cent.
#include <cstdio>

#include "tests/rates/studies.h"

namespace surefoot {

namespace {

/// The rates over many studies of one truth; a line of the table is printed.
Rates ratesOf(const char* truth, const Claim& claim, const std::function<std::vector<Evidence>(Random&)>& study) {
  Random random(20261129);
  Rates rates;
  for (int i = 0; i < kStudies; ++i) {
    const auto j = judge(kRegistry, claim, study(random), 1);
    EXPECT_TRUE(j) << j.error().message;
    if (j) rates.shares[static_cast<std::size_t>(j->verdict)] += 1.0 / kStudies;
  }
  std::printf("%-14s %-46s agrees %5.1f %%, differs %5.1f %%, undecided %5.1f %%\n", claim.kind.c_str(), truth,
              100 * rates.agrees(), 100 * rates.differs(), 100 * rates.undecided());
  return rates;
}

Claim claimOf(const char* kind, Json arguments) {
  return {.id = "X", .kind = kind, .says = "", .arguments = std::move(arguments)};
}

/// A reference with 23 falls and a condition that changes them by so many per cent.
std::function<std::vector<Evidence>(Random&)> changed(double perCent, Design design, int lives = 40) {
  return [=](Random& random) {
    Study study(design, lives, random);
    return std::vector<Evidence>{study.condition("a", 23), study.condition("b", 23 * (1 + perCent / 100), "a")};
  };
}

constexpr Design kDesigns[] = {Design::Lives, Design::OwnQFunctions, Design::SharedQFunctions};

}  // namespace

TEST(RuleRates, NothingThereIsSeldomSignificant) {
  for (const Design design : kDesigns) {
    const Claim claim = claimOf("significant", {{"conditions", {"b"}}});
    EXPECT_LT(ratesOf("no change", claim, changed(0, design)).agrees(), 0.012);
    EXPECT_LT(ratesOf("more falls instead of fewer (+30 %)", claim, changed(30, design)).agrees(), 0.002);
  }
  const Claim claim = claimOf("significant", {{"conditions", {"b"}}});
  EXPECT_GT(ratesOf("-45 %, own Q-functions", claim, changed(-45, Design::OwnQFunctions)).agrees(), 0.99);
  EXPECT_LT(ratesOf("-20 %, own Q-functions", claim, changed(-20, Design::OwnQFunctions)).differs(), 0.02);
}

TEST(RuleRates, NoDifferenceTakesEquivalence) {
  const Claim claim = claimOf("no-difference", {{"conditions", {"b"}}});
  for (const Design design : kDesigns) {
    const Rates none = ratesOf("no change", claim, changed(0, design));
    EXPECT_LT(none.differs(), 0.015);
    const Rates atMargin = ratesOf("at the margin (-15 %)", claim, changed(-15, design));
    EXPECT_LT(atMargin.agrees(), 0.035) << "2.5 % by its construction";
    EXPECT_LT(ratesOf("beyond it (-30 %)", claim, changed(-30, design)).agrees(), 0.002);
  }
  EXPECT_GT(ratesOf("no change, 200 pairs", claim, changed(0, Design::OwnQFunctions, 200)).agrees(), 0.95);
}

TEST(RuleRates, AReplicationIsJudgedByTheDifferenceOfTwoStudies) {
  const auto rates = [](const char* truth, double thesis, double ours) {
    Random theirs(7);
    Rates sum;
    for (int i = 0; i < kStudies; ++i) {
      const auto first = changed(thesis, Design::Lives)(theirs);
      const auto test = testOfUnits(first[0], first[1], "falls");
      const double before = meanOf(first[0], "falls").value;
      const double found = 100 * (meanOf(first[1], "falls").value - before) / before;
      const auto j =
          judge(kRegistry, claimOf("reduction", {{"thesis", found}, {"thesis_p", test->p}, {"conditions", {"b"}}}),
                changed(ours, Design::OwnQFunctions)(theirs), 1);
      if (j) sum.shares[static_cast<std::size_t>(j->verdict)] += 1.0 / kStudies;
    }
    std::printf("%-14s %-46s agrees %5.1f %%, differs %5.1f %%, undecided %5.1f %%\n", "replication", truth,
                100 * sum.agrees(), 100 * sum.differs(), 100 * sum.undecided());
    return sum;
  };
  const Rates right = rates("the thesis is exactly right (-45 %)", -45, -45);
  EXPECT_GT(right.agrees(), 0.88);
  EXPECT_LT(right.differs(), 0.09);
  EXPECT_LT(rates("exactly right (-15 %)", -15, -15).differs(), 0.09);
  EXPECT_GT(rates("off by half (-45 % for -22 %)", -45, -22).differs(), 0.5);
  EXPECT_GT(rates("wrong (-45 % for none)", -45, 0).differs(), 0.95);
  EXPECT_LT(rates("wrong (-15 % for none)", -15, 0).agrees(), 0.02);
  EXPECT_LT(rates("the other way (-15 % for +15 %)", -15, 15).agrees(), 0.02)
      << "where their own forty lives showed the other sign";
}

TEST(RuleRates, OrdersOfEqualConditionsAreUndecided) {
  const auto six = [](double others) {
    return [others](Random& random) {
      Study study(Design::OwnQFunctions, 40, random);
      std::vector<Evidence> all = {study.condition("0", 20)};
      for (int i = 1; i < 6; ++i) all.push_back(study.condition(std::to_string(i), others));
      return all;
    };
  };
  const Claim lowest = claimOf("lowest", {{"conditions", {"0", "1", "2", "3", "4", "5"}}});
  const Rates equal = ratesOf("six equal conditions", lowest, six(20));
  EXPECT_LT(equal.agrees(), 0.05);
  EXPECT_LT(equal.differs(), 0.05);
  EXPECT_GT(ratesOf("the first falls 40 % less", lowest, six(33)).agrees(), 0.95);
  EXPECT_GT(ratesOf("the first falls twice as often", lowest, six(10)).differs(), 0.95);
}

TEST(RuleRates, TheBestOfManyIsNotCalledBetterThanItIs) {
  const auto equals = [](Random& random) {
    Study study(Design::OwnQFunctions, 40, random);
    std::vector<Evidence> all = {study.condition("a", 23)};
    for (int i = 0; i < 9; ++i) all.push_back(study.condition("TRL " + std::to_string(i), 23 * 0.8, "a"));
    return all;
  };
  const auto claim = [](double low, double high) {
    return claimOf("extreme", {{"low", low}, {"high", high}, {"conditions", {"TRL *"}}});
  };
  EXPECT_LT(ratesOf("nine of -20 %, -20 % claimed", claim(-30, -10), equals).differs(), 0.03);
  EXPECT_LT(ratesOf("nine of -20 %, -45 % claimed", claim(-55, -40), equals).agrees(), 0.02);
}

TEST(RuleRates, ARatioAndAMeanHoldTheirIntervals) {
  const Claim ratio = claimOf("ratio", {{"low", 1.5}, {"high", 2.5}, {"conditions", {"b", "a"}}});
  EXPECT_LT(ratesOf("2.0 for 1.5 to 2.5", ratio, changed(100, Design::OwnQFunctions)).differs(), 0.01);
  EXPECT_LT(ratesOf("1.0 for 1.5 to 2.5", ratio, changed(0, Design::OwnQFunctions)).agrees(), 0.01);
  EXPECT_LT(ratesOf("4.0 for 1.5 to 2.5", ratio, changed(300, Design::OwnQFunctions)).agrees(), 0.01);
  const auto value = [](double thesis) { return claimOf("value", {{"thesis", thesis}, {"conditions", {"a"}}}); };
  EXPECT_LT(ratesOf("23 falls for 23", value(23), changed(0, Design::Lives)).differs(), 0.03);
  EXPECT_GT(ratesOf("23 falls for 46", value(46), changed(0, Design::Lives)).differs(), 0.95);
}

}  // namespace surefoot
