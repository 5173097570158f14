// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/store_schema.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <set>

#include "core/files/read_file.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

/// The oldest stores do not have this table.
constexpr const char* kMeasures = R"(
CREATE TABLE IF NOT EXISTS measures (condition INTEGER NOT NULL, life INTEGER NOT NULL, episode INTEGER NOT NULL,
  name TEXT NOT NULL, value REAL NOT NULL, PRIMARY KEY (condition, life, episode, name)) WITHOUT ROWID;
)";
constexpr const char* kSinceFormat2 = R"(
ALTER TABLE lives ADD COLUMN lives_version INTEGER;
ALTER TABLE lives ADD COLUMN program TEXT;
ALTER TABLE lives ADD COLUMN checksum TEXT;
ALTER TABLE pre_learned ADD COLUMN checksum TEXT;
CREATE TABLE IF NOT EXISTS q_functions (content TEXT PRIMARY KEY, file BLOB NOT NULL);
)";

constexpr const char* kSchema = R"(
CREATE TABLE experiment (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE conditions (condition INTEGER PRIMARY KEY, name TEXT NOT NULL, reference TEXT NOT NULL,
  text TEXT NOT NULL, configuration TEXT NOT NULL,
  lives INTEGER NOT NULL, goal_reward REAL NOT NULL, step_time REAL NOT NULL);
CREATE TABLE pre_learned (condition INTEGER NOT NULL, q_function INTEGER NOT NULL, episodes INTEGER NOT NULL,
  falls INTEGER NOT NULL, steps INTEGER NOT NULL, average_reward REAL NOT NULL, reached INTEGER NOT NULL,
  hash TEXT NOT NULL,
  PRIMARY KEY (condition, q_function)) WITHOUT ROWID;
CREATE TABLE lives (condition INTEGER NOT NULL, life INTEGER NOT NULL, q_function INTEGER, episodes INTEGER NOT NULL,
  steps INTEGER NOT NULL, falls INTEGER NOT NULL, states_outside INTEGER NOT NULL, diverged TEXT, hash TEXT NOT NULL,
  PRIMARY KEY (condition, life)) WITHOUT ROWID;
CREATE TABLE episodes (condition INTEGER NOT NULL, life INTEGER NOT NULL, episode INTEGER NOT NULL,
  transitions INTEGER NOT NULL, reward REAL NOT NULL, falls INTEGER NOT NULL, ending INTEGER NOT NULL,
  PRIMARY KEY (condition, life, episode)) WITHOUT ROWID;
CREATE TABLE endings (ending INTEGER PRIMARY KEY, name TEXT NOT NULL);
INSERT INTO endings VALUES (0, 'end'), (1, 'success'), (2, 'fall'), (3, 'truncated');
)";

/// With single blanks, and none beside brackets and commas.
std::string tidy(const std::string& sql) {
  std::string text;
  bool blank = false;
  for (const char c : sql) {
    if (c == ' ' || c == '\n' || c == '\t' || c == '\r') {
      blank = true;
      continue;
    }
    const bool tight = c == '(' || c == ')' || c == ',';
    const bool behindTight = text.empty() || text.back() == '(' || text.back() == ')' || text.back() == ',';
    if (blank && !tight && !behindTight) text += ' ';
    blank = false;
    text += c;
  }
  return text;
}

/// The parts of the database: one line per table, index, view or trigger. Very long lines are cut.
std::set<std::string> partsOf(SQLite::Database& db) {
  std::set<std::string> parts;
  SQLite::Statement row(db,
                        "SELECT type, name, tbl_name, substr(ifnull(sql, ''), 1, 4000) FROM sqlite_master LIMIT 20");
  while (row.executeStep())
    parts.insert(fmt::format("{} {} {} {}", row.getColumn(0).getString(), row.getColumn(1).getString(),
                             row.getColumn(2).getString(), tidy(row.getColumn(3).getString())));
  return parts;
}

std::set<std::string> partsMadeBy(std::initializer_list<const char*> scripts) {
  SQLite::Database empty(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  for (const char* script : scripts) empty.exec(script);
  return partsOf(empty);
}

}  // namespace

void makeTables(SQLite::Database& db) {
  db.exec(kSchema);
  addTables(db);
}

void addTables(SQLite::Database& db) {
  db.exec(kMeasures);
  if (db.execAndGet("PRAGMA user_version").getInt() < kFormat) db.exec(kSinceFormat2);
  db.exec(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", kApplicationId, kFormat));
}

void distrust(SQLite::Database& db) {
  sqlite3* const handle = db.getHandle();
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  for (const auto& [limit, most] : {std::pair{SQLITE_LIMIT_ATTACHED, 0},
                                    {SQLITE_LIMIT_TRIGGER_DEPTH, 1},
                                    {SQLITE_LIMIT_EXPR_DEPTH, 100},
                                    {SQLITE_LIMIT_COLUMN, 100},
                                    {SQLITE_LIMIT_SQL_LENGTH, 100'000},
                                    {SQLITE_LIMIT_LENGTH, 1'000'000'000}})
    sqlite3_limit(handle, limit, most);
  db.exec("PRAGMA cell_size_check = ON; PRAGMA mmap_size = 0");
}

void obey(SQLite::Database& db, const std::atomic<bool>* interrupted) {
  constexpr int kSteps = 10'000;  // steps of SQLite's virtual machine: less than a millisecond
  const auto look = [](void* flag) -> int { return *static_cast<const std::atomic<bool>*>(flag) ? 1 : 0; };
  sqlite3_progress_handler(db.getHandle(), interrupted ? kSteps : 0, look, const_cast<std::atomic<bool>*>(interrupted));
}

Status checkTables(SQLite::Database& db, const std::string& path) {
  const int id = db.execAndGet("PRAGMA application_id").getInt();
  const int format = db.execAndGet("PRAGMA user_version").getInt();
  if (id != kApplicationId) return fileError(path, "it is not a store of results.");
  if (format < kOldestFormat || format > kFormat)
    return fileError(path, fmt::format("its format is {}, and this program reads formats {} to {}.", format,
                                       kOldestFormat, kFormat));
  static const std::set<std::string> first = partsMadeBy({kSchema}), measured = partsMadeBy({kSchema, kMeasures}),
                                     now = partsMadeBy({kSchema, kMeasures, kSinceFormat2});
  const std::set<std::string> there = partsOf(db);
  const bool ours = format == kFormat ? there == now : there == first || there == measured;
  if (ours) return Done{};
  for (const std::string& part : there)
    if (!now.contains(part) && !measured.contains(part))
      return fileError(path, fmt::format("its {} is not as Surefoot makes it; such a store is not read.",
                                         shortened(part.substr(0, part.find(' ', part.find(' ') + 1)))));
  return fileError(path, "it lacks tables of a store; such a store is not read.");
}

}  // namespace surefoot
