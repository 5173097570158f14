// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that can be chosen by name or set: `surefoot list`, its manual page and completions tell it.
#pragma once

#include <string>
#include <vector>

#include "core/parameters.h"
#include "core/registry.h"

namespace surefoot {

/// Every parameter that any environment with any agent declares, each key once.
Parameters everyParameter(const Registry& registry);

/// The robots that come with the program as files, by the names of their files.
std::vector<EnvironmentEntry> shelvedRobots(const Registry& registry);

/// "now", "next episode", "new table".
const char* whenName(When when);

/// "0 … 1", "replacing or accumulating".
std::string rangeText(const Parameter& parameter);

}  // namespace surefoot
