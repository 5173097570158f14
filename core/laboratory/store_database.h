// SPDX-License-Identifier: GPL-3.0-or-later
// What the files of the store share: the database behind it, and errors in words.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include "core/laboratory/store.h"

namespace surefoot {

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

struct Store::Database {
  Database(const std::string& path, int flags) : db(path, flags, 0), writes((flags & SQLite::OPEN_READWRITE) != 0) {}
  ~Database() {
    addLife.reset(), addEpisode.reset(), addMeasure.reset();
    // A file that can be read where nothing can be written. If it fails, the next who opens it will try again.
    if (writes) static_cast<void>(db.tryExec("PRAGMA journal_mode = DELETE"));
  }
  SQLite::Database db;
  bool writes;
  // Prepared once, because a life has a thousand episodes.
  std::unique_ptr<SQLite::Statement> addLife, addEpisode, addMeasure;
};

}  // namespace surefoot
