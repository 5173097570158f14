// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of a plan that are written by the program and not by a person.
#pragma once

#include "core/plans/plan.h"

namespace surefoot {

/// A text in quotation marks as TOML has it.
std::string tomlText(const std::string& text);

/// A [[condition]] block that runs exactly what a configuration says, whatever [base] holds: it takes nothing over from
/// there. A life is as long as the configuration says; without an end it is 9 minutes long, or 500 episodes where there
/// is no clock. It begins as the configuration says: with the file, which must still hold the same values, or with
/// Q-functions that are learned before as its own was. What no plan can say is refused.
Result<std::string> conditionToml(const Registry& registry, const Configuration& configuration,
                                  const std::string& name);

/// "live: trl", or "live: trl (2)" where the plan has such a name already.
std::string freeName(const Plan& plan, const std::string& name);

}  // namespace surefoot
