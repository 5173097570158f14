// SPDX-License-Identifier: GPL-3.0-or-later
// Pages of the handbook that are made from declarations: methods, parameters, commands.
#pragma once

#include "core/handbook/handbook.h"

namespace surefoot {

inline constexpr const char *kMethods = "Methods", *kWorlds = "Worlds", *kParameters = "Parameters",
                            *kCommands = "Commands";

/// Policies, learning rules and representations, a page each, with equation, source and parameters.
Handbook methodPages(const Registry& registry);
/// Worlds, a page each: what the state and the actions are, presets, scenarios, parameters.
Handbook worldPages(const Registry& registry);
/// A page a group of parameters.
Handbook parameterPages(const Registry& registry);
Handbook commandPages(const std::vector<CommandHelp>& commands);

}  // namespace surefoot
