// SPDX-License-Identifier: GPL-3.0-or-later
// How often the rule for two studies of one change says agrees, differs or undecided, on simulated truth: a study of
// the thesis's size finds a change and its p, ours finds another, of the same truth, of half of it, or of none.
#include <cmath>

#include "tests/core/recipes/claim_evidence.h"

namespace surefoot {

namespace {

constexpr int kStudies = 1000, kLivesASide = 40;

double gauss(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * std::acos(-1.0) * random.uniform());
}

/// Forty lives whose falls have this mean and a deviation of 45 of 200, as without pre-learning.
Evidence study(const char* name, const char* reference, double mean, Random& random) {
  Evidence e = condition(name, mean, reference, 0, kLivesASide);
  for (LifeMeasures& life : e.lives) life.falls = std::max(0.0, mean * (1 + 0.22 * gauss(random)));
  return e;
}

/// Shares of agrees, differs, undecided.
std::array<double, 3> sharesOf(double thesisChange, double ourChange, std::uint64_t seed) {
  Random random(seed);
  std::array<double, 3> shares{};
  for (int i = 0; i < kStudies; ++i) {
    const auto measured = [&](double change) {
      return std::vector<Evidence>{study("before", "", 200, random),
                                   study("after", "before", 200 * (1 + change / 100), random)};
    };
    const auto theirs = measured(thesisChange), ours = measured(ourChange);
    const double before = meanOf(theirs[0], "falls").value;
    const double found = 100 * (meanOf(theirs[1], "falls").value - before) / before;
    const Claim claim{.id = "X",
                      .kind = "reduction",
                      .says = "",
                      .arguments = {{"thesis", found},
                                    {"thesis_p", testOfUnits(theirs[0], theirs[1], "falls")->p},
                                    {"conditions", Json::array({"after"})}}};
    const auto j = judge(kRegistry, claim, ours, 1);
    EXPECT_TRUE(j) << j.error().message;
    if (j) shares[static_cast<std::size_t>(j->verdict)] += 1.0 / kStudies;
  }
  return shares;
}

enum { kAgrees, kDiffers, kUndecided };

}  // namespace

TEST(Replication, ARightThesisIsSeldomSaidToDiffer) {
  for (const double change : {-45.0, -20.0, -7.0}) {
    const auto shares = sharesOf(change, change, 1);
    EXPECT_LT(shares[kDiffers], 0.08) << change << ": 5 % by its construction";
  }
  EXPECT_GT(sharesOf(-45, -45, 2)[kAgrees], 0.9) << "a large change is decided";
  EXPECT_GT(sharesOf(-7, -7, 3)[kUndecided], 0.6) << "a small one is not, by forty lives";
}

TEST(Replication, AWrongThesisIsFound) {
  EXPECT_GT(sharesOf(-45, 0, 4)[kDiffers], 0.95);
  EXPECT_GT(sharesOf(-45, -22, 5)[kDiffers], 0.9) << "off by half";
  EXPECT_LT(sharesOf(-20, 0, 6)[kAgrees], 0.02);
  EXPECT_LT(sharesOf(-7, 7, 7)[kAgrees], 0.01) << "never in the other direction";
}

}  // namespace surefoot
