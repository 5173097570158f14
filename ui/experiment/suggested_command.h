// SPDX-License-Identifier: GPL-3.0-or-later
// What a file that the window wrote is good for without a window: a command that can be copied into a shell.
#pragma once

#include <QString>

#include "ui/session/running_life.h"

namespace surefoot {

/// The command that goes on with the file; it works as it is, whatever the name and the environment.
QString suggestedCommand(SavedAs what, const QString& path, const RunningLife& life);

}  // namespace surefoot
