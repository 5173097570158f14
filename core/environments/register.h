// SPDX-License-Identifier: GPL-3.0-or-later
// The environments of this folder, by name: worlds with published results to hold the learners against.
#pragma once

#include "core/registry.h"

namespace surefoot {

void registerEnvironments(Registry& registry);

}  // namespace surefoot
