// SPDX-License-Identifier: GPL-3.0-or-later
// How a store is made and opened: by one process to write, by any number to read, wherever the file lies.
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <thread>

#include "core/files/file_stamp.h"
#include "core/files/read_file.h"
#include "core/store/store_database.h"

namespace surefoot {

namespace {

namespace fs = std::filesystem;

/// A path as a URI for SQLite.
std::string uriOf(const std::string& path, const char* query) {
  std::error_code failed;
  std::string uri = "file://";
  for (const char c : fs::absolute(path, failed).lexically_normal().string()) {
    if (c == '?' || c == '#' || c == '%')
      uri += fmt::format("%{:02x}", static_cast<unsigned char>(c));
    else
      uri += c;
  }
  return uri + query;
}

bool isThere(const std::string& path) {
  std::error_code failed;
  const auto size = fs::file_size(path, failed);
  return !failed && size > 0;
}

/// Whether the file's header says that there is a log.
bool wantsLog(const std::string& path) {
  constexpr std::size_t kReadVersion = 19;
  const auto head = readHead(path, kReadVersion + 1);
  return head && head->size() > kReadVersion && (*head)[kReadVersion] == 2;
}

/// A copy of store and log, or of the journal of an unfinished change, in a folder where SQLite can combine them.
Result<std::pair<TemporaryFolder, std::string>> copyOf(const std::string& path) {
  std::error_code failed;
  std::string folder = (fs::temp_directory_path(failed) / "surefoot-XXXXXX").string();
  if (failed || !mkdtemp(folder.data()))
    return fileError(path, "it was left in the middle of writing, and there is no folder to put it right in.");
  TemporaryFolder temporary{fs::path(folder)};
  const std::string copy = folder + "/store.sqlite";
  for (const char* part : {"", "-wal", "-journal"}) {
    if (!isThere(path + part)) continue;
    if (!fs::copy_file(path + part, copy + part, failed)) {
      if (*part && !isThere(path + part)) continue;  // its writer took it away in this moment
      return fileError(path, "it cannot be copied to be read.");
    }
    fs::permissions(copy + part, fs::perms::owner_all, failed);
  }
  if (isThere(copy + "-journal"))  // SQLite undoes the change when the copy is opened to write
    static_cast<void>(guarded<Done>(path, [&]() -> Status {
      SQLite::Database(copy, SQLite::OPEN_READWRITE).execAndGet("SELECT count(*) FROM sqlite_master");
      return Done{};
    }));
  return std::pair(std::move(temporary), copy);
}

/// The message about a store that was copied without its log.
constexpr const char* kAlone =
    "it was copied while it was written, or after the program was killed, and without its log ({}-wal): the lives that "
    "were written last may be missing.";

/// The message about a store without checksums.
constexpr const char* kUnchecked =
    "an earlier version wrote it, without checksums: whether its numbers are those that were written cannot be seen. "
    "Going on with --resume notes them.";

}  // namespace

bool Store::missing(const std::string& path) {
  std::error_code error;
  const auto status = fs::symlink_status(path, error);
  if (!fs::exists(status)) return true;
  return fs::is_regular_file(path, error) && fs::file_size(path, error) == 0;
}

namespace {

/// Gives a finished file a name that is still free; returns 0 or the error number.
int giveName(const std::string& from, const std::string& to) {
  if (link(from.c_str(), to.c_str()) == 0) return 0;
  if (errno == EEXIST) return errno;
  // The file system has no hard links; the lock keeps others away.
  return Store::missing(to) && rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

}  // namespace

namespace {

/// Removes files of processes that were killed while they made a store. The caller must hold the lock.
void clearLitter(const std::string& path) {
  std::error_code failed;
  const fs::path folder = fs::path(path).parent_path();
  const std::string prefix = fs::path(path).filename().string() + ".new-";
  std::vector<fs::path> litter;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? fs::path(".") : folder, failed))
    if (entry.path().filename().string().starts_with(prefix)) litter.push_back(entry.path());
  for (const fs::path& file : litter) fs::remove(file, failed);
}

}  // namespace

// The store is made under another name and renamed when it is complete, so that an incomplete one is never found.
Result<Store> Store::create(const std::string& path, const StoredPlan& plan) {
  const auto exists = fileError(path, "it exists already; name another file, or go on with --resume.");
  if (!missing(path)) return exists;
  auto lock = StoreLock::take(path);
  if (!lock) return lock.error();
  if (!missing(path)) return exists;
  clearLitter(path);
  const std::string meanwhile = fmt::format("{}.new-{}", path, getpid());
  const auto made = guarded<Done>(path, [&]() -> Status {
    SQLite::Database db(meanwhile, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    fillStore(db, plan);
    return Done{};
  });
  if (!made) {
    unlink(meanwhile.c_str());
    return made.error();
  }
  unlink(path.c_str());  // an empty file, if any
  // Left by an earlier store that was removed; SQLite would replay them into the new one.
  for (const char* rest : {"-wal", "-shm", "-journal"}) unlink((path + rest).c_str());
  const int why = giveName(meanwhile, path);
  unlink(meanwhile.c_str());
  if (why != 0)
    return why == EEXIST ? exists : fileError(path, fmt::format("it cannot be made: {}.", std::strerror(why)));
  return openLocked(path, std::move(*lock), nullptr);
}

namespace {

/// Checks that the store exists and is a regular file.
Status checkFile(const std::string& path) {
  std::error_code failed;
  if (Store::missing(path)) return fileError(path, "there is no such store.");
  if (!fs::is_regular_file(path, failed)) return fileError(path, "it is not a regular file.");
  return Done{};
}

/// Finds a store that was copied while it was written, without its log: a note, or an error if it is damaged.
Status checkAlone(SQLite::Database& db, const std::string& path, std::string& note) {
  const bool writing =
      db.execAndGet("SELECT ifnull((SELECT value FROM experiment WHERE key = 'writing'), '0')").getString() == "1";
  const bool earlier = db.execAndGet("PRAGMA user_version").getInt() == kOldestFormat && wantsLog(path);
  if (!writing && !earlier) return Done{};
  note = fileError(path, fmt::format(kAlone, fs::path(path).filename().string())).message;
  if (db.execAndGet("PRAGMA quick_check(1)").getString() != "ok")
    return fileError(path, "it was copied while it was written, and without its log: the file is damaged.");
  return Done{};
}

}  // namespace

Result<Store> Store::openToWrite(const std::string& path, const std::atomic<bool>* interrupted) {
  if (const Status s = checkFile(path); !s) return s.error();
  auto lock = StoreLock::take(path);
  if (!lock) return lock.error();
  return openLocked(path, std::move(*lock), interrupted);
}

Result<Store> Store::openLocked(const std::string& path, StoreLock lock, const std::atomic<bool>* interrupted) {
  return guarded<Store>(path, [&]() -> Result<Store> {
    const bool alone = !isThere(path + "-wal");
    auto data = std::make_unique<Database>(path, std::move(lock));
    obey(data->db, interrupted);
    if (const Status s = checkTables(data->db, path); !s) return s.error();
    if (alone)
      if (const Status s = checkAlone(data->db, path, data->note); !s) return s.error();
    data->beginWriting();
    obey(data->db, nullptr);  // a life is written whole
    return Store(path, std::move(data));
  });
}

Result<Store> Store::openAt(const std::string& path, const std::string& uri, TemporaryFolder folder, bool alone,
                            const std::atomic<bool>* interrupted) {
  return guarded<Store>(path, [&]() -> Result<Store> {
    auto data = std::make_unique<Database>(uri, std::move(folder));
    obey(data->db, interrupted);
    if (const Status s = checkTables(data->db, path); !s) return s.error();
    if (alone)
      if (const Status s = checkAlone(data->db, path, data->note); !s) return s.error();
    if (data->format() < kFormat && data->note.empty()) data->note = fileError(path, kUnchecked).message;
    return Store(path, std::move(data));
  });
}

Result<Store> Store::open(const std::string& path, const std::atomic<bool>* interrupted) {
  if (const Status s = checkFile(path); !s) return s.error();
  const bool log = isThere(path + "-wal"), journal = isThere(path + "-journal");
  const auto read = [&](const std::string& uri, TemporaryFolder folder) {
    return openAt(path, uri, std::move(folder), !log && !StoreLock::isHeld(path), interrupted);
  };
  // If the log is missing, SQLite would make one: a reader must not do that, and it fails where nothing can be written.
  if (!log && !journal && wantsLog(path) && !StoreLock::isHeld(path)) return read(uriOf(path, "?immutable=1"), {});
  auto store = read(uriOf(path, ""), {});
  if (store || (!log && !journal) || StoreLock::isHeld(path)) return store;
  auto copy = copyOf(path);
  if (!copy) return store;
  return read(uriOf(copy->second, ""), std::move(copy->first));
}

namespace {

/// While this stays the same, a copy of the file and then of its log is of one moment: whatever is written into the
/// file meanwhile is in the log, too. The log begins anew, with another head, only when the file has all of it.
std::string momentOf(const std::string& path) {
  constexpr std::size_t kHeadOfLog = 32;  // with the two numbers that are drawn anew
  struct stat s {};
  if (isThere(path + "-wal") && stat(path.c_str(), &s) == 0)
    if (const auto head = readHead(path + "-wal", kHeadOfLog)) return fmt::format("{} {}", s.st_ino, *head);
  return stampOf(path).identity + ' ' + stampOf(path + "-journal").identity;
}

}  // namespace

Result<Store> Store::peek(const std::string& path, const std::atomic<bool>* interrupted) {
  constexpr int kCopies = 5;
  for (int i = 0; i < kCopies && !(interrupted && *interrupted); ++i) {
    if (i > 0) std::this_thread::sleep_for(std::chrono::milliseconds(30));
    if (const Status s = checkFile(path); !s) return s.error();
    const std::string moment = momentOf(path);
    const bool alone = !isThere(path + "-wal") && !StoreLock::isHeld(path);
    auto copy = copyOf(path);
    if (!copy) return copy.error();
    if (momentOf(path) != moment) continue;
    return openAt(path, uriOf(copy->second, ""), std::move(copy->first), alone, interrupted);
  }
  return fileError(path, "it changes faster than it can be copied to be read.");
}

}  // namespace surefoot
