// SPDX-License-Identifier: GPL-3.0-or-later
// A lock that ends with its process, whatever ends it: the system holds it (flock), so a lock file that was left by a
// crash, in an earlier boot or with other content in it is no lock, and a number of a process that is in use again says
// nothing.
#pragma once

#include <QString>

namespace surefoot {

class FileLock {
 public:
  FileLock() = default;
  ~FileLock() { release(); }
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;

  /// Takes the lock, for which `path` is made where it is missing. Where it cannot be made, there is no lock.
  static FileLock take(const QString& path);
  bool held() const { return file_ >= 0; }
  /// Gives it back; its file goes.
  void release();

 private:
  QString path_;
  int file_ = -1;
};

}  // namespace surefoot
