// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of a store. A store from elsewhere may hold anything that SQLite can run: views that never end, triggers
// that change what is written, columns that are computed. So its tables are compared with ours before one is read.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <atomic>
#include <string>

#include "core/basics/result.h"

namespace surefoot {

inline constexpr int kApplicationId = 0x53726674;  // "Srft"
inline constexpr int kOldestFormat = 1, kFormat = 2;

/// The tables of an empty store of this format.
void makeTables(SQLite::Database& db);
/// Tables and columns that a store of an earlier format has not got.
void addTables(SQLite::Database& db);

/// Nothing that the file says is run, and SQLite trusts it as little as it can.
void distrust(SQLite::Database& db);
/// From now on whatever takes long ends soon after the flag is set, as an error of kind Interrupted; nullptr: nothing
/// ends it.
void obey(SQLite::Database& db, const std::atomic<bool>* interrupted);
/// It is a store of a format that we read, and has its tables and nothing else.
Status checkTables(SQLite::Database& db, const std::string& path);

}  // namespace surefoot
