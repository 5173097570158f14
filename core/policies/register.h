// SPDX-License-Identifier: GPL-3.0-or-later
// The policies of this folder, by name.
#pragma once

#include "core/registry.h"

namespace surefoot {

void registerPolicies(Registry& registry);

}  // namespace surefoot
