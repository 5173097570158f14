// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/store_database.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <chrono>
#include <thread>

#include "core/basics/version.h"
#include "core/files/read_file.h"

namespace surefoot {

namespace {

constexpr int kPatience = 5'000, kLongPatience = 60'000;  // [ms] to wait for locks of others

void mark(SQLite::Database& db, bool writing) {
  db.exec(fmt::format("INSERT OR REPLACE INTO experiment VALUES ('writing', '{}')", writing ? 1 : 0));
}

/// Turns on the log, so that others can read; they cannot where the file system has no shared memory.
void useLog(SQLite::Database& db) {
  if (db.execAndGet("PRAGMA journal_mode = WAL").getString() != "wal") {
    db.exec("PRAGMA locking_mode = EXCLUSIVE; PRAGMA journal_mode = WAL");
    db.exec("BEGIN EXCLUSIVE; COMMIT");
  }
  db.exec("PRAGMA synchronous = NORMAL");
}

/// Stores the Q-functions that lives begin with, except those too large for SQLite.
void addQFunctions(SQLite::Database& db, const StoredPlan& plan) {
  constexpr std::size_t kLargest = 900'000'000;
  SQLite::Statement row(db, "INSERT INTO q_functions VALUES (?, ?)");
  for (const auto& [content, file] : plan.qFunctions) {
    const std::string bytes = file->write();
    if (bytes.size() > kLargest) continue;
    row.bind(1, content);
    row.bindNoCopy(2, bytes.data(), static_cast<int>(bytes.size()));
    row.exec();
    row.reset();
  }
}

}  // namespace

Error plainError(const std::string& path, const SQLite::Exception& e) {
  const auto say = [&](const char* sentence) { return fileError(path, sentence); };
  switch (e.getErrorCode()) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return inUse(path);
    case SQLITE_FULL:
      return say(
          "the disk is full; what was written before is kept. Make room and go on: `experiment` with --resume, "
          "`reproduce` as it is.");
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return say("it cannot be written to; look at its permissions and those of its folder.");
    case SQLITE_CANTOPEN:
      return say("it cannot be opened or made there; look at the folder and its permissions.");
    case SQLITE_NOTADB:
      return say("it is not a store of results (not an SQLite file).");
    case SQLITE_INTERRUPT:
      return Error{path + ": interrupted.", ErrorKind::Interrupted};
    case SQLITE_NOMEM:
      return say("it needs more memory than there is.");
    case SQLITE_CORRUPT:
      return say("the file is damaged.");
    case SQLITE_IOERR:
      return say("it cannot be read or written; the disk may be full or damaged.");
    default:
      return fileError(path, fmt::format("{}.", e.what()));
  }
}

Store::Database::Database(const std::string& uri, TemporaryFolder folder)
    : copy(std::move(folder)),
      db(uri, SQLite::OPEN_READONLY | SQLite::OPEN_URI, kPatience) {
  distrust(db);
}

Store::Database::Database(const std::string& path, StoreLock taken)
    : lock(std::move(taken)),
      db(path, SQLite::OPEN_READWRITE, kPatience) {
  distrust(db);
}

std::string Store::Database::valueOf(const char* key) {
  SQLite::Statement row(db, "SELECT value FROM experiment WHERE key = ?");
  SQLite::bind(row, key);
  return row.executeStep() ? CheckedRow(row, "experiment").text(0) : "";
}

void Store::Database::setValue(const char* key, const std::string& value) {
  SQLite::Statement row(db, "INSERT OR REPLACE INTO experiment VALUES (?, ?)");
  SQLite::bind(row, key, value);
  row.exec();
}

void Store::Database::noteChecksums() {
  for (const StoredPreLearning& p : readPreLearned()) {
    SQLite::Statement row(db, "UPDATE pre_learned SET checksum = ? WHERE condition = ? AND q_function = ?");
    SQLite::bind(row, hexText(checksumOf(p)), p.condition, p.qFunction);
    row.exec();
  }
  const std::vector<StoredLife> lives = readLives();
  std::uint64_t sum = 0;
  for (const StoredLife& l : lives) {
    SQLite::Statement row(db, "UPDATE lives SET checksum = ? WHERE condition = ? AND life = ?");
    const std::uint64_t own = checksumOf(l);
    SQLite::bind(row, checksumText(own, checksumOf(readEpisodes(l)), checksumOf(readMeasures(l.condition, l.life))),
                 l.condition, l.life);
    row.exec();
    sum ^= own;
  }
  setValue(kPlanSum, hexText(checksumOf(readPlan())));
  setValue(kLivesSum, hexText(sum));
}

void Store::Database::beginWriting() {
  useLog(db);
  SQLite::Transaction whole(db);
  if (format() < kFormat) {
    addTables(db);
    db.exec("PRAGMA user_version = 1");  // so checksums that are still missing are not checked
    noteChecksums();
    db.exec(fmt::format("PRAGMA user_version = {}", kFormat));
  }
  readPlan();
  for (const StoredLife& l : readLives()) livesSum ^= checksumOf(l);
  mark(db, true);
  whole.commit();
  writing = unsettled = true;
  db.setBusyTimeout(kLongPatience);  // other kinds of readers may lock it for a while
}

Store::Database::~Database() {
  addLife.reset(), addEpisode.reset(), addMeasure.reset();
  if (!writing) return;
  try {
    db.setBusyTimeout(kPatience);
    mark(db, false);
  } catch (const std::exception&) {
    return;  // the log stays beside the file, and readers read both
  }
  static_cast<void>(db.tryExec("PRAGMA wal_checkpoint(TRUNCATE)"));
  // Back to a file without a log, which can be read where nothing can be written. We wait for readers, but not long:
  // everything is in the file by now.
  constexpr int kTries = 20;
  for (int i = 0; i < kTries && db.tryExec("PRAGMA journal_mode = DELETE") == SQLITE_BUSY; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

void fillStore(SQLite::Database& db, const StoredPlan& plan) {
  SQLite::Transaction whole(db);
  makeTables(db);
  SQLite::Statement pair(db, "INSERT INTO experiment VALUES (?, ?)");
  for (const auto& [key, value] : {std::pair<const char*, std::string>{"version", kVersion},
                                   {"title", plan.title},
                                   {"seed", std::to_string(plan.seed)},
                                   {"paired", plan.paired ? "1" : "0"},
                                   {"shard", std::to_string(plan.shard)},
                                   {"shards", std::to_string(plan.shards)},
                                   {kLivesSum, hexText(0)},
                                   {kGrowth, plan.growth}}) {
    if (key == kGrowth && value.empty()) continue;  // a fixed number of lives
    SQLite::bind(pair, key, value);
    pair.exec();
    pair.reset();
  }
  SQLite::Statement row(db, "INSERT INTO conditions VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    const StoredCondition& c = plan.conditions[i];
    SQLite::bind(row, static_cast<int>(i), c.name, c.reference, c.text, c.configuration, c.lives, c.goalReward,
                 c.stepTime);
    row.exec();
    row.reset();
  }
  addQFunctions(db, plan);
  StoredPlan as = plan;
  as.version = kVersion;
  SQLite::bind(pair, kPlanSum, hexText(checksumOf(as)));
  pair.exec();
  whole.commit();
}

}  // namespace surefoot
