// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/running/run_names.h"

#include <gtest/gtest.h>

#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

/// A life of `episodes` episodes of ten steps, under "softmax" at first, whose policy changed as said.
RunCurve lived(int episodes, const std::string& atTheEnd, const std::vector<Change>& changes,
               const std::string& agent = "sarsa") {
  std::vector<CurvePoint> points;
  for (int i = 1; i <= episodes; ++i) points.push_back({i, 10 * i, i / 2, 0.0});
  RunCurves curves;
  curves.update(agent, atTheEnd, points, changes);
  return curves.live();
}

}  // namespace

TEST(RunNames, ACurveIsNamedByItsPolicyAndItsLearningRule) {
  const Registry registry = fullRegistry();
  EXPECT_EQ(nameOf(lived(50, "trl", {}), registry), "TRL, Sarsa");
  EXPECT_EQ(nameOf(lived(50, "trl", {}, "sarsa-2q"), registry), "TRL, Sarsa_2Q");
}

TEST(RunNames, ACurveThatChangedIsNamedByBoth) {
  const Registry registry = fullRegistry();
  const RunCurve curve = lived(50, "softmax", {{205, "policy", "epsilon-greedy", "softmax"}});
  EXPECT_EQ(nameOf(curve, registry), "ε-greedy → Softmax, Sarsa");
}

// What is chosen after the last episode did nothing yet: the past keeps its name.
TEST(RunNames, TurningAKnobNeverRenamesThePast) {
  const Registry registry = fullRegistry();
  EXPECT_EQ(nameOf(lived(50, "epsilon-greedy", {{500, "policy", "epsilon-greedy", "softmax"}}), registry),
            "ε-greedy, Sarsa");
  EXPECT_EQ(nameOf(lived(50, "softmax", {{0, "policy", "epsilon-greedy", "softmax"}}), registry), "Softmax, Sarsa");
}

TEST(RunNames, APolicyThatWasLeftAtOnceIsNotNamed) {
  const Registry registry = fullRegistry();
  const RunCurve curve =
      lived(50, "softmax", {{205, "policy", "epsilon-greedy", "trl"}, {205, "policy", "trl", "softmax"}});
  EXPECT_EQ(policiesOf(curve, registry), "ε-greedy → Softmax");
}

TEST(RunNames, OfManyPoliciesTheFirstAndTheLastAreNamed) {
  const Registry registry = fullRegistry();
  const RunCurve curve = lived(90, "greedy",
                               {{205, "policy", "epsilon-greedy", "trl"},
                                {405, "policy", "trl", "softmax"},
                                {605, "policy", "softmax", "greedy"}});
  EXPECT_EQ(policiesOf(curve, registry), "ε-greedy → … → Greedy");
}

TEST(RunNames, HowALifeBeganIsPartOfItsName) {
  const Registry registry = fullRegistry();
  RunCurves curves;
  curves.setBegan("pre-learned (scenario 2)");
  curves.update("sarsa", "trl", {{1, 10, 0, 0.0}}, {});
  EXPECT_EQ(nameOf(curves.live(), registry), "TRL, Sarsa, pre-learned (scenario 2)");
}

}  // namespace surefoot
