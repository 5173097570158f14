// SPDX-License-Identifier: GPL-3.0-or-later
// From a block of a plan file to its conditions: one for every combination of the values in its lists.
#pragma once

#include <map>
#include <memory>
#include <set>

#include "core/plans/plan.h"
#include "core/plans/plan_file.h"
#include "core/plans/plan_systems.h"

namespace surefoot {

inline constexpr std::size_t kMostConditions = 10'000;

/// One combination of the values of a block: all settings, their places in the file, and the keys that lists varied.
struct Combination {
  std::map<std::string, const PlanSetting*> where;
  std::vector<Assignment> all, varied;

  const std::string* find(const std::string& key) const {
    for (const Assignment& a : all)
      if (a.key == key) return &a.value;
    return nullptr;
  }
};

/// All combinations of a block; the last list varies fastest. At most kMostConditions + 1.
std::vector<Combination> combine(const PlanBlock& block);

/// The settings that all conditions of a plan share.
struct PlanHead {
  std::string reference;  ///< for conditions that name no reference
  std::uint64_t seed = 1;
  int lives = 40;
  std::string series;  ///< mixed into every seed: plans of different series have no life in common
  DrawnSystem system;  ///< the one whose conditions are made
  bool paired = false;
  std::vector<Assignment> assignments;  ///< from the command line; they override the plan
  std::optional<std::string> preset;    ///< likewise
  /// The parts from which a life was already made on trial, to see whether this is possible.
  std::shared_ptr<std::set<std::string>> tried = std::make_shared<std::set<std::string>>();
};

Result<Condition> makeCondition(const Registry& registry, const std::string& path, const PlanHead& head,
                                const Combination& combination, int line);

}  // namespace surefoot
