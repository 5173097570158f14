// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/store_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include "core/files/read_file.h"

namespace surefoot {

namespace {

constexpr int kTries = 10;  // isHeld() in another process holds the lock for a moment

std::string lockOf(const std::string& storePath) {
  return storePath + "-lock";
}

/// Whether the name still belongs to the open file.
bool isNamed(const std::string& file, int descriptor) {
  struct stat open {
  }, there{};
  return fstat(descriptor, &open) == 0 && stat(file.c_str(), &there) == 0 && open.st_ino == there.st_ino &&
         open.st_dev == there.st_dev;
}

}  // namespace

Error inUse(const std::string& storePath) {
  return fileError(storePath, "another process is using it; wait for it to end, or write to another file.");
}

Result<StoreLock> StoreLock::take(const std::string& storePath) {
  const std::string file = lockOf(storePath);
  for (;;) {
    const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor < 0)
      return fileError(storePath, fmt::format("it cannot be written there: {}; look at the folder and its permissions.",
                                              std::strerror(errno)));
    // A file system without locks has no locks for SQLite either: then no process can be kept out.
    bool held = true;
    for (int i = 0; held && i < kTries; ++i) {
      if (i > 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
      held = flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    }
    if (held) {
      close(descriptor);
      return inUse(storePath);
    }
    if (isNamed(file, descriptor)) return StoreLock(file, descriptor);
    close(descriptor);  // the process that held the lock has just removed the file
  }
}

bool StoreLock::isHeld(const std::string& storePath) {
  const int descriptor = open(lockOf(storePath).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor < 0) return false;
  const bool held = flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(descriptor);
  return held;
}

StoreLock::StoreLock(StoreLock&& other) noexcept
    : file_(std::move(other.file_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

StoreLock::~StoreLock() {
  if (descriptor_ < 0) return;
  unlink(file_.c_str());
  close(descriptor_);
}

}  // namespace surefoot
