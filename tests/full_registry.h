// SPDX-License-Identifier: GPL-3.0-or-later
// What the program offers: the core's parts and the physics' worlds.
#pragma once

#include "core/register/register.h"
#include "physics/register.h"

namespace surefoot {

inline Registry fullRegistry() {
  Registry registry;
  registerCore(registry);
  registerPhysics(registry);
  return registry;
}

}  // namespace surefoot
