// SPDX-License-Identifier: GPL-3.0-or-later
// An experiment of many conditions, as a plan file says it (TOML). The handbook's page "Plans" describes it.
//
// A condition is a configuration, how many lives are lived under it, and what these have learned before. Its text names
// everything in which it differs from the defaults; its lives' seeds are derived from the plan's master seed and this
// text (without the length of a life), so that conditions are independent of each other and of their order, and the
// same condition in two plans has the same lives, unless the plans say that they are of two series.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/experiment/configuration.h"
#include "core/plans/plan_growth.h"

namespace surefoot {

/// Q-functions that lives begin with, each learned in a life of its own (thesis, section 4.2.1).
struct PreLearning {
  Configuration configuration;  ///< until and episodes (the cap) are set; Q-function j is its life number j
  int pool = 5;                 ///< how many; 0: one for every life
  std::string text;             ///< describes the pre-learning; conditions with the same text share Q-functions

  /// The Q-function that life number `life` begins with.
  int numberFor(int life) const { return pool == 0 ? life : life % pool; }
};

struct Condition {
  std::string name;
  std::string text;
  std::string reference;  ///< name of the condition that it is compared with; empty: none
  Configuration configuration;
  std::optional<PreLearning> preLearning;
  std::vector<Assignment> varied;  ///< values that lists in the plan varied: key as in the plan, value
};

struct Plan {
  std::string title;
  std::uint64_t seed = 1;
  int lives = 40;                ///< per condition
  bool paired = false;           ///< life i has the same seeds in every condition
  PlanGrowth growth{};           ///< lives = "decided", or [search]: `lives` and `livesEach` are what is wanted so far
  std::vector<int> livesEach{};  ///< a condition's lives; empty: all have `lives`
  int systems = 0;  ///< every condition on each of so many drawn systems, "system 7: …"; 0: the plan draws none
  std::vector<Condition> conditions;

  int livesOf(std::size_t condition) const { return livesEach.empty() ? lives : livesEach[condition]; }
};

/// Settings of the command line, which replace those of the plan.
struct PlanChanges {
  std::optional<int> lives;
  std::optional<std::uint64_t> seed;
  std::vector<Assignment> assignments;  ///< for every condition
  std::optional<std::string> preset{};  ///< for every condition and its pre-learning, if its environment has it
  const std::atomic<bool>* interrupted = nullptr;  ///< set by anyone: reading ends with an error
};

/// Reads a plan; an error names file, line and allowed values. Files named in the plan are looked for in its folder.
Result<Plan> readPlan(const Registry& registry, const std::string& path, const PlanChanges& changes);
/// The same from a text; `path` is named in messages.
Result<Plan> parsePlan(const Registry& registry, const std::string& text, const std::string& path,
                       const PlanChanges& changes);

/// "environment=pendulum scenario=2 … policy.threshold=50": the names, and every parameter that has another value than
/// under these names alone. Parameters of policies that are not chosen are left out.
std::string describe(const Registry& registry, const Configuration& configuration);

}  // namespace surefoot
