// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the source files of the store: the database behind it, and errors in words.
//
// While a store is written, it has a log of the new content (SQLite's WAL, "results.sqlite-wal"), so that others can
// read meanwhile; the log's content goes into the file itself within a quarter of a second. A mark in the file says
// that a process writes. A file with the mark but without a log was copied alone, and may lack the lives written last.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include <filesystem>

#include "core/files/read_file.h"
#include "core/store/store.h"
#include "core/store/store_checks.h"
#include "core/store/store_lock.h"
#include "core/store/store_schema.h"

namespace surefoot {

/// SQLite's error in plain words.
Error plainError(const std::string& path, const SQLite::Exception& e);

/// Calls f, and turns whatever is thrown into an error that names the file.
template <class T, class F>
Result<T> guarded(const std::string& path, F f) {
  try {
    return f();
  } catch (const SQLite::Exception& e) {
    return plainError(path, e);
  } catch (const Damaged& e) {
    return fileError(path, std::string(e.what()) + "; the file is damaged.");
  } catch (const std::bad_alloc&) {
    return fileError(path, "it needs more memory than there is.");
  } catch (const std::exception& e) {
    return fileError(path, std::string("it cannot be read: ") + e.what() + ".");
  }
}

/// A folder for a copy, removed with this object; an empty path: no folder.
class TemporaryFolder {
 public:
  TemporaryFolder() = default;
  explicit TemporaryFolder(std::filesystem::path path) : path_(std::move(path)) {}
  TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }

 private:
  std::filesystem::path path_;
};

struct Store::Database {
  /// To read; if it is a copy, it lies in `folder`.
  Database(const std::string& uri, TemporaryFolder folder);
  /// To write.
  Database(const std::string& path, StoreLock lock);
  ~Database();

  /// Adds tables, columns and checksums that older stores do not have, and sets the mark.
  void beginWriting();
  int format() { return db.execAndGet("PRAGMA user_version").getInt(); }
  std::string valueOf(const char* key);
  void setValue(const char* key, const std::string& value);

  // Reads and checks the content, within a transaction of the caller.
  StoredPlan readPlan();
  std::vector<StoredLife> readLives();
  std::vector<StoredPreLearning> readPreLearned();
  std::vector<StoredEpisode> readEpisodes(const StoredLife& life);
  std::vector<StoredMeasure> readMeasures(int condition, int life);
  /// The row of a life with its checksum; empty: there is none.
  std::optional<std::pair<StoredLife, std::string>> readLife(int condition, int life);
  void noteChecksums();

  std::optional<StoreLock> lock;  // released when everything else is closed
  TemporaryFolder copy;
  SQLite::Database db;
  bool writing = false, unsettled = false;
  std::uint64_t livesSum = 0;  ///< combined checksums of all lives, while the store is written
  std::string note;
  // Prepared once, because a life has a thousand episodes.
  std::unique_ptr<SQLite::Statement> addLife, addEpisode, addMeasure;
};

/// Makes the tables of an empty store and writes the plan into them.
void fillStore(SQLite::Database& db, const StoredPlan& plan);

/// Which keys of the table `experiment` hold checksums.
inline constexpr const char *kPlanSum = "plan_checksum", *kLivesSum = "lives_checksum", *kGrowth = "growth";

}  // namespace surefoot
