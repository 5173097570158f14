// SPDX-License-Identifier: GPL-3.0-or-later
// A world and a policy that the caller of the library brings along: environment "own", policy "own".
#pragma once

#include <memory>

#include "app/library/surefoot.h"
#include "core/registry.h"

namespace surefoot {

/// Whether one of the caller's functions failed since somebody looked. Shared with the parts; one thread.
struct Mishap {
  bool ofPolicy = false;
};

/// Adds the parts that are there (not NULL) to a registry. An error: the task is none.
Status addOwnParts(Registry& registry, const surefoot_world* world, const surefoot_policy* policy,
                   const std::shared_ptr<Mishap>& mishap);

/// The task of a world of the caller's (surefoot_world.task).
Result<Task> ownTask(const char* text);

}  // namespace surefoot
