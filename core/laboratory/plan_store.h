// SPDX-License-Identifier: GPL-3.0-or-later
// The store that a plan is run into: a new one, or one that holds a part of its lives.
#pragma once

#include "core/store/store.h"

namespace surefoot {

struct PlanStore {
  std::string path;
  bool resume = false;        ///< go on with what is there; false: there must be nothing
  bool anyVersion = false;    ///< even if another version lived it whose lives are others
  std::string remedy{};       ///< a sentence behind the error that says so: how to go on all the same
  int shard = 1, shards = 1;  ///< see LabOptions
  const std::atomic<bool>* interrupted = nullptr;
};

/// An error says in what the store that is there differs from the plan.
Result<Store> openPlanStore(const Registry& registry, const Plan& plan, const PlanStore& wanted);

}  // namespace surefoot
