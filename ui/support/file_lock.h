// SPDX-License-Identifier: GPL-3.0-or-later
// A lock that ends with its process, however the process ends: the system holds it (flock). A file alone is no lock, so
// a file that was left by a crash or an earlier boot locks nothing, whatever is in it. Process numbers, which can be
// used again, play no part.
#pragma once

#include <QString>

namespace surefoot {

class FileLock {
 public:
  FileLock() = default;
  ~FileLock() { release(); }
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;

  /// Takes the lock; the file `path` is made if it is missing. If it cannot be made, there is no lock.
  static FileLock take(const QString& path);
  bool held() const { return file_ >= 0; }
  /// Gives it back; its file goes.
  void release();

 private:
  QString path_;
  int file_ = -1;
};

}  // namespace surefoot
