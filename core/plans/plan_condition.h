// SPDX-License-Identifier: GPL-3.0-or-later
// From one combination of the values of a plan's block to the condition that it describes.
#pragma once

#include <memory>
#include <set>

#include "core/plans/plan.h"
#include "core/plans/plan_combination.h"
#include "core/plans/plan_systems.h"

namespace surefoot {

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
