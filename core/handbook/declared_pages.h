// SPDX-License-Identifier: GPL-3.0-or-later
// Pages of the handbook that are made from declarations: methods, parameters, commands.
#pragma once

#include "core/handbook/handbook.h"

namespace surefoot {

inline constexpr const char *kMethods = "Methods", *kWorlds = "Worlds", *kParameters = "Parameters",
                            *kCommands = "Commands";

/// Policies, learning rules and representations, a page each, with equation, source and parameters.
Handbook methodPages(const Registry& registry, const HandbookSpeech& speech = {});
/// Worlds, a page each: what the state and the actions are, presets, scenarios, parameters.
Handbook worldPages(const Registry& registry, const HandbookSpeech& speech = {});
/// A page a group of parameters.
Handbook parameterPages(const Registry& registry, const HandbookSpeech& speech = {});
Handbook commandPages(const std::vector<CommandHelp>& commands);

/// "Representation" of "features": of parameters whose keys begin so.
std::string groupTitle(std::string_view key);
/// The pendulum, whose defaults are told.
const EnvironmentEntry& usualWorld(const Registry& registry);

}  // namespace surefoot
