// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that core/ has to choose from, by name.
#pragma once

#include "core/registry.h"

namespace surefoot {

/// The learning rules, feature maps, policies and environments of core/.
void registerCore(Registry& registry);

}  // namespace surefoot
