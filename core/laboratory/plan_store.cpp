// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/plan_store.h"

#include <fmt/format.h>

namespace surefoot {

Result<Store> openPlanStore(const Registry& registry, const Plan& plan, const PlanStore& wanted) {
  auto stored = planToStore(registry, plan);
  if (!stored) return stored.error();
  stored->shard = wanted.shard, stored->shards = wanted.shards;
  if (!wanted.resume || Store::missing(wanted.path)) return Store::create(wanted.path, *stored);
  auto store = Store::openToWrite(wanted.path, wanted.interrupted);
  if (!store) return store;
  const auto there = store->plan();
  if (!there) return there.error();
  if (const Status s = checkSamePlan(*there, *stored, wanted.path); !s) return s.error();
  if (const Status s = checkSameShard(*there, *stored, wanted.path); !s) return s.error();
  const auto lives = store->lives();
  if (!lives) return lives.error();
  if (const Status s = checkLivesVersion(*lives, wanted.path); !s && !wanted.anyVersion)
    return Error{wanted.remedy.empty() ? s.error().message : s.error().message + " " + wanted.remedy, s.error().kind};
  if (plan.growth) return store;  // it wants as many lives as its results ask for
  const int planned = there->conditions.front().lives;
  if (plan.lives < planned)
    return Error{fmt::format("--lives: {} holds {} lives a condition; going on, there can only be more, not {}.",
                             wanted.path, planned, plan.lives)};
  if (plan.lives > planned)
    if (const Status s = store->setLives(plan.lives); !s) return s.error();
  return store;
}

}  // namespace surefoot
