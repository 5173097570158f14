// SPDX-License-Identifier: GPL-3.0-or-later
// Adds the Box2D worlds, their presets and their scenarios to the registry.
#pragma once

#include "core/registry.h"

namespace surefoot {

void registerPhysics(Registry& registry);

}  // namespace surefoot
