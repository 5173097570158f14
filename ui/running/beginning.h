// SPDX-License-Identifier: GPL-3.0-or-later
// How a life began, in a few words that stand in its title, its legend and the status line.
#pragma once

#include <string>

#include "core/experiment/configuration.h"

namespace surefoot {

/// "pre-learned (scenario 2)", "with walks.safetensors", "carried over"; empty: with an empty table. `began` is the
/// configuration that the life began with.
std::string beginningOf(const Configuration& began);

}  // namespace surefoot
