// SPDX-License-Identifier: GPL-3.0-or-later
// A store's tables as CSV files, a row an observation: conditions.csv, lives.csv, episodes.csv,
// and of tasks that measure something measures.csv.
#pragma once

#include "core/store/store.h"

namespace surefoot {

/// Writes the files into a folder, made if it is not there; refused if one of them is. All or none. `option` is what
/// messages call the folder. `forSpreadsheets`: they begin with a byte order mark, without which Excel takes "ε" for
/// two letters, and which other programs would take for part of the first head.
Status exportCsv(const Store& store, const std::string& folder, const std::string& option,
                 bool forSpreadsheets = false);

}  // namespace surefoot
