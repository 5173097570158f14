// SPDX-License-Identifier: GPL-3.0-or-later
// Two logs of lives (train --log), row by row.
#pragma once

#include "core/difference/difference.h"

namespace surefoot {

/// The first row and column with another text. An error: a file that cannot be read, or a line that is no row.
Result<RecordDifference> logDifference(const std::string& first, const std::string& second,
                                       const std::atomic<bool>* interrupted);

}  // namespace surefoot
