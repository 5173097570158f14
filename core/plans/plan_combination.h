// SPDX-License-Identifier: GPL-3.0-or-later
// The combinations of the values in a block's lists, and the names that conditions get from them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/plans/plan_file.h"

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

/// Whether a condition's setting holds in its pre-learning, too: not what the policy does, and no step size; what is
/// learned of risk does.
inline bool isInherited(std::string_view key) {
  return !key.starts_with("policy.") && (!key.ends_with("step_size") || key.starts_with("risk."));
}

/// All combinations of a block; the last list varies fastest. At most kMostConditions + 1.
std::vector<Combination> combine(const PlanBlock& block);

/// A condition's name: "TRL {policy.threshold}" with the values in place of the keys. With `whole`, values from lists
/// that are not in the name are added.
std::string nameOf(const Combination& c, std::string name, bool whole);

/// "{policy.epsilon}", where a name still has one; else nothing.
std::string placeholderIn(const std::string& name);

}  // namespace surefoot
