// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plans/plan_systems.h"

#include <gtest/gtest.h>

#include <set>

#include "core/plans/plan.h"
#include "tests/full_registry.h"

namespace surefoot {

namespace {

const Registry kPendulums = fullRegistry();

const std::string kSystems =
    "[systems]\ncount = 8\nset.environment.pole_length = [0.1, 0.4]\nset.environment.start_angle = [0, 0.2]\n";

std::string planWith(const std::string& systems) {
  return "lives = 2\nreference = \"a\"\n" + systems +
         "[base]\nminutes = 1\n[[condition]]\nname = \"a\"\n"
         "[[condition]]\nname = \"b\"\npolicy = \"greedy\"\npre-learning.scenario = \"2\"\npre-learning.until = 198\n";
}

}  // namespace

TEST(PlanSystems, EveryConditionIsOnEverySystem) {
  const auto plan = parsePlan(kPendulums, planWith(kSystems), "p.toml", {});
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->systems, 8);
  ASSERT_EQ(plan->conditions.size(), 16u);
  const Condition& b = plan->conditions[5];
  EXPECT_EQ(b.name, "system 3: b");
  EXPECT_EQ(b.reference, "system 3: a");
  const double length = b.configuration.parameters.get("environment.pole_length");
  EXPECT_EQ(plan->conditions[4].configuration.parameters.get("environment.pole_length"), length);
  EXPECT_EQ(b.preLearning->configuration.parameters.get("environment.pole_length"), length);
  EXPECT_NE(plan->conditions[6].configuration.parameters.get("environment.pole_length"), length);
}

TEST(PlanSystems, CoverTheirRangesAndStayTheSameUnderAnotherMasterSeed) {
  PlanChanges other;
  other.seed = 7;
  const auto plan = parsePlan(kPendulums, planWith(kSystems), "p.toml", {});
  const auto again = parsePlan(kPendulums, planWith(kSystems), "p.toml", other);
  ASSERT_TRUE(plan && again);
  std::set<int> lengths, angles;  // the eighth of the range that a system lies in
  for (std::size_t i = 0; i < plan->conditions.size(); i += 2) {
    const auto& parameters = plan->conditions[i].configuration.parameters;
    const auto& same = again->conditions[i].configuration.parameters;
    for (const char* key : {"environment.pole_length", "environment.start_angle"})
      EXPECT_EQ(parameters.get(key), same.get(key));
    lengths.insert(static_cast<int>(8 * std::log(parameters.get("environment.pole_length") / 0.1) / std::log(4.0)));
    angles.insert(static_cast<int>(8 * parameters.get("environment.start_angle") / 0.2));
    EXPECT_NE(plan->conditions[i].configuration.seed, again->conditions[i].configuration.seed);
  }
  EXPECT_EQ(lengths.size(), 8u) << "in the logarithm, one in each eighth";
  EXPECT_EQ(angles.size(), 8u);
}

TEST(PlanSystems, WhatIsWrongIsNamedWithItsLine) {
  const auto refused = [](const std::string& systems, const std::string& words) {
    const auto plan = parsePlan(kPendulums, planWith(systems), "p.toml", {});
    ASSERT_FALSE(plan) << systems;
    EXPECT_NE(plan.error().message.find(words), std::string::npos) << plan.error().message;
  };
  refused("[systems]\ncount = 1\nset.environment.pole_length = [0.1, 0.4]\n", "count, from 2 on");
  refused("[systems]\ncount = 3\n", "count, from 2 on");
  refused("[systems]\ncount = 9999\nset.environment.pole_length = [0.1, 0.4]\n", "1000");
  refused("[systems]\ncount = 3\nset.environment.pole_length = [0.4, 0.1]\n", "[low, high]");
  refused("[systems]\ncount = 3\nset.environment.pole_length = 0.4\n", "line 5");
  refused("[systems]\ncount = 3\nset.environment.pole_length = [0.1, 99]\n", "pole_length");
  refused("[systems]\ncuont = 3\n", "did you mean count");
}

TEST(PlanSystems, TheNumberIsReadFromTheName) {
  EXPECT_EQ(systemOf("system 12: TRL 50"), std::pair(12, std::string("TRL 50")));
  for (const char* name : {"TRL 50", "system: TRL", "system x: TRL", "system 4 TRL"})
    EXPECT_EQ(systemOf(name), std::pair(0, std::string(name)));
}

}  // namespace surefoot
