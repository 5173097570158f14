// SPDX-License-Identifier: GPL-3.0-or-later
// Writes blocks of a plan for the user.
#pragma once

#include "core/plans/plan.h"

namespace surefoot {

/// A text in quotation marks as TOML has it.
std::string tomlText(const std::string& text);

/// A [[condition]] block that runs exactly this configuration; it takes nothing over from [base]. A life has the length
/// in the configuration; without one it is 9 minutes long, or 500 episodes where there is no clock. It begins as in the
/// configuration: with the file, which must still have the same values, or with Q-functions that are learned before in
/// the same way. Refused if a plan cannot express the configuration.
Result<std::string> conditionToml(const Registry& registry, const Configuration& configuration,
                                  const std::string& name);

/// "live: trl", or "live: trl (2)" if the plan has this name already.
std::string freeName(const Plan& plan, const std::string& name);

}  // namespace surefoot
