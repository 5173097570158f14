// SPDX-License-Identifier: GPL-3.0-or-later
// A file that appears whole or not at all: written without a name in the same folder, synced, then given its name.
// Used by one thread; createNew also reads the process's umask.
#pragma once

#include <string>
#include <string_view>

#include "core/basics/result.h"

namespace surefoot {

class WholeFile {
 public:
  /// Claims a place for a file that does not exist yet, so that a long run does not end with nowhere to write.
  /// `what` names it in messages: "log".
  static Result<WholeFile> createNew(const std::string& what, const std::string& path);
  /// The same for a file that may exist: it keeps its content until commit(), which replaces it in one step.
  static Result<WholeFile> createOrReplace(const std::string& what, const std::string& path);

  WholeFile(WholeFile&& other) noexcept;
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(WholeFile&&) = delete;
  /// Without commit() nothing is left behind.
  ~WholeFile();

  /// A name under which another program can open the file to write the content, until commit().
  std::string openName() const;
  /// Writes a part of the content, where all of it at once would be too much.
  Status append(std::string_view content);
  /// Writes the rest and gives the file its name. Call once.
  Status commit(std::string_view content = {});

 private:
  WholeFile(std::string what, std::string path, std::string temporary, int descriptor, bool replaces)
      : what_(std::move(what)),
        path_(std::move(path)),
        temporary_(std::move(temporary)),
        descriptor_(descriptor),
        replaces_(replaces) {}
  static Result<WholeFile> open(const std::string& what, const std::string& path, bool replaces);
  bool giveName() const;
  bool takePlace() const;

  std::string what_, path_;
  std::string temporary_;  // its name meanwhile; empty where the file system lets a file have none
  int descriptor_ = -1;
  bool replaces_ = false;
};

/// Writes a file that may exist, whole.
Status writeWhole(const std::string& what, const std::string& path, std::string_view content);

}  // namespace surefoot
