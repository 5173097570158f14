// SPDX-License-Identifier: GPL-3.0-or-later
// Only one process at a time writes into a store. It holds a lock on a file beside it ("results.sqlite-lock"); the
// system releases the lock when the process ends, in whatever way. Readers need no lock.
#pragma once

#include <string>

#include "core/basics/result.h"

namespace surefoot {

class StoreLock {
 public:
  /// Refused while another process holds it.
  static Result<StoreLock> take(const std::string& storePath);
  /// Whether a process writes now.
  static bool isHeld(const std::string& storePath);

  StoreLock(StoreLock&& other) noexcept;
  StoreLock& operator=(StoreLock&&) = delete;
  /// Releases the lock, and removes its file.
  ~StoreLock();

 private:
  StoreLock(std::string file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}
  std::string file_;
  int descriptor_ = -1;
};

/// "another process is using it …"
Error inUse(const std::string& storePath);

}  // namespace surefoot
