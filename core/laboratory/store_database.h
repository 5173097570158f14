// SPDX-License-Identifier: GPL-3.0-or-later
// What the files of the store share: the database behind it, and errors in words.
//
// While it is written a store keeps a log of what is new (SQLite's WAL, "results.sqlite-wal"), so that others read it
// meanwhile; the log's content goes into the file itself within a quarter of a second. A mark in the file says that
// somebody writes: one that has it and no log beside it was copied alone, and may lack what was written last.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include <filesystem>

#include "core/laboratory/store.h"
#include "core/laboratory/store_lock.h"

namespace surefoot {

inline constexpr int kApplicationId = 0x53726674;  // "Srft"
inline constexpr int kOldestFormat = 1, kFormat = 2;

/// What SQLite says, in words that help.
Error plainError(const std::string& path, const SQLite::Exception& e);

/// Calls f, and turns what SQLite throws into an error.
template <class T, class F>
Result<T> guarded(const std::string& path, F f) {
  try {
    return f();
  } catch (const SQLite::Exception& e) {
    return plainError(path, e);
  }
}

/// A folder for a copy that goes with it; none if its name is empty.
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
  /// To read; `folder` holds it if it is a copy.
  Database(const std::string& uri, TemporaryFolder folder);
  /// To write.
  Database(const std::string& path, StoreLock lock);
  ~Database();

  /// Tables and columns that stores of earlier days have not got, and the mark.
  void beginWriting();

  std::optional<StoreLock> lock;  // given back when everything else is closed
  TemporaryFolder copy;
  SQLite::Database db;
  bool writing = false, unsettled = false;
  std::string note;
  // Prepared once, because a life has a thousand episodes.
  std::unique_ptr<SQLite::Statement> addLife, addEpisode, addMeasure;
};

/// The tables of an empty store, with what is known of the plan.
void fillStore(SQLite::Database& db, const StoredPlan& plan);

}  // namespace surefoot
