// SPDX-License-Identifier: GPL-3.0-or-later
// A command for a file that the window wrote; it can be copied into a shell and works without a window.
#pragma once

#include <QString>

#include "ui/running/running_life.h"

namespace surefoot {

/// The command that continues from the file; it works without changes for every name and environment. `written`: how
/// far the life in the file is; the window's own numbers may be a moment older.
QString suggestedCommand(SavedAs what, const QString& path, const RunningLife& life, const LifeProgress& written);

}  // namespace surefoot
