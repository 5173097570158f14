// SPDX-License-Identifier: GPL-3.0-or-later
// A store's tables as CSV files, a row an observation: conditions.csv, lives.csv, episodes.csv.
#pragma once

#include "core/laboratory/store.h"

namespace surefoot {

/// Writes the three files into a folder, made if it is not there; refused if one of them is. All or none. `option` is
/// what messages call the folder.
Status exportCsv(const Store& store, const std::string& folder, const std::string& option);

}  // namespace surefoot
