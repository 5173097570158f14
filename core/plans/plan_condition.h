// SPDX-License-Identifier: GPL-3.0-or-later
// From a block of a plan file to its conditions: every combination of its lists is one.
#pragma once

#include <map>
#include <memory>
#include <set>

#include "core/plans/plan.h"
#include "core/plans/plan_file.h"

namespace surefoot {

inline constexpr std::size_t kMostConditions = 10'000;

/// One combination of all values of a block: what it is set to, where that stands, and which keys a list varied.
struct Combination {
  std::map<std::string, const PlanSetting*> where;
  std::vector<Assignment> all, varied;

  const std::string* find(const std::string& key) const {
    for (const Assignment& a : all)
      if (a.key == key) return &a.value;
    return nullptr;
  }
};

/// All combinations of a block, the list that stands last varying fastest; no more than kMostConditions + 1.
std::vector<Combination> combine(const PlanBlock& block);

/// What all conditions of a plan share.
struct PlanHead {
  std::string reference;  ///< of conditions that name none
  std::uint64_t seed = 1;
  int lives = 40;
  bool paired = false;
  std::vector<Assignment> assignments;  ///< from the command line; the last word
  std::optional<std::string> preset;    ///< likewise
  /// What a life was made of already, to see whether it can be.
  std::shared_ptr<std::set<std::string>> tried = std::make_shared<std::set<std::string>>();
};

Result<Condition> makeCondition(const Registry& registry, const std::string& path, const PlanHead& head,
                                const Combination& combination, int line);

}  // namespace surefoot
