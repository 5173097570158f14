// SPDX-License-Identifier: GPL-3.0-or-later
// Who writes into a store: one process at a time. A lock on a file beside it ("results.sqlite-lock"), which the system
// takes back with the process, however that ends. Readers need none.
#pragma once

#include <string>

#include "core/basics/result.h"

namespace surefoot {

class StoreLock {
 public:
  /// Refused while another holds it.
  static Result<StoreLock> take(const std::string& storePath);
  /// Whether somebody writes now.
  static bool isHeld(const std::string& storePath);

  StoreLock(StoreLock&& other) noexcept;
  StoreLock& operator=(StoreLock&&) = delete;
  /// Gives it back, and removes the file.
  ~StoreLock();

 private:
  StoreLock(std::string file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}
  std::string file_;
  int descriptor_ = -1;
};

/// "another process is using it …"
Error inUse(const std::string& storePath);

}  // namespace surefoot
