// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of a store. A store from elsewhere may hold anything that SQLite can run: views that never end, triggers
// that change written values, columns that are computed. So its tables are compared with ours before one is read.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <atomic>
#include <string>

#include "core/basics/result.h"

namespace surefoot {

inline constexpr int kApplicationId = 0x53726674;  // "Srft"
inline constexpr int kOldestFormat = 1, kFormat = 2;

/// Makes the tables of an empty store of this format.
void makeTables(SQLite::Database& db);
/// Adds tables and columns that a store of an earlier format does not have.
void addTables(SQLite::Database& db);

/// From now on no code in the file is run, and SQLite trusts the file as little as possible.
void distrust(SQLite::Database& db);
/// From now on long queries end soon after the flag is set, with an error of kind Interrupted; nullptr: they are never
/// interrupted.
void obey(SQLite::Database& db, const std::atomic<bool>* interrupted);
/// Checks that the store has a format that we read, with the tables of this format and nothing else.
Status checkTables(SQLite::Database& db, const std::string& path);

}  // namespace surefoot
