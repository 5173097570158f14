// SPDX-License-Identifier: GPL-3.0-or-later
// A store's tables as CSV files, one row per observation: conditions.csv, lives.csv, episodes.csv, and measures.csv if
// the tasks have measures.
#pragma once

#include "core/store/store.h"

namespace surefoot {

/// Writes the files into a folder, which is made if needed; refused if one of the files exists. All or none are
/// written. Messages call the folder `option`. `forSpreadsheets`: the files begin with a byte order mark. Without it
/// Excel reads "ε" as two letters; other programs would read it as part of the first column's name.
Status exportCsv(const Store& store, const std::string& folder, const std::string& option,
                 bool forSpreadsheets = false);

}  // namespace surefoot
