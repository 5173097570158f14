// SPDX-License-Identifier: GPL-3.0-or-later
// What a task's states and actions are called on the screen.
#pragma once

#include <QString>

#include "core/environment.h"

namespace surefoot {

/// "α", or the title if there is no symbol.
QString symbolOf(const StateVariable& variable);
/// "pole angle α [rad]"
QString axisTitleOf(const StateVariable& variable);
/// "1.50", or the name of the action.
QString actionNameOf(const Task& task, std::size_t action);

}  // namespace surefoot
