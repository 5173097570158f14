// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/support/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QFile>
#include <utility>

namespace surefoot {

namespace {

/// Whether the open file still has this path: another process may have removed it meanwhile.
bool isStillThere(int file, const char* path) {
  struct stat open {
  }, named{};
  return fstat(file, &open) == 0 && stat(path, &named) == 0 && open.st_ino == named.st_ino &&
         open.st_dev == named.st_dev;
}

}  // namespace

FileLock::FileLock(FileLock&& other) noexcept : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  if (this == &other) return *this;
  release();
  path_ = std::move(other.path_);
  file_ = std::exchange(other.file_, -1);
  return *this;
}

FileLock FileLock::take(const QString& path) {
  constexpr int kTries = 5;
  const QByteArray name = QFile::encodeName(path);
  FileLock lock;
  for (int i = 0; i < kTries; ++i) {
    const int file = open(name.constData(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (file < 0) return lock;
    if (flock(file, LOCK_EX | LOCK_NB) != 0) {
      close(file);
      return lock;
    }
    if (isStillThere(file, name.constData())) {
      lock.path_ = path;
      lock.file_ = file;
      return lock;
    }
    close(file);
  }
  return lock;
}

void FileLock::release() {
  if (file_ < 0) return;
  unlink(QFile::encodeName(path_).constData());
  close(std::exchange(file_, -1));
}

}  // namespace surefoot
