// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that can be chosen by name, with every parameter (`surefoot list`).
#pragma once

#include <string>

#include "core/registry.h"

namespace surefoot {

/// {environments, robots, features, agents, policies, presets, scenarios, figures, parameters}, ending in a newline.
std::string listAsJson(const Registry& registry);
/// The same for people.
std::string listAsTable(const Registry& registry);

}  // namespace surefoot
