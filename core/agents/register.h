// SPDX-License-Identifier: GPL-3.0-or-later
// The learning rules of this folder, by name.
#pragma once

#include "core/registry.h"

namespace surefoot {

void registerAgents(Registry& registry);

}  // namespace surefoot
