// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/saved/followable.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/files/file_stamp.h"
#include "core/files/tensor_file.h"

namespace surefoot {

namespace {

/// The kind of a file of tensors; empty: it is none of ours. Only its head is read.
std::string kindOf(const std::string& path) {
  std::string kind;
  const auto look = [&](const TensorFile& head) -> Status {
    if (const auto entry = head.about.find("kind"); entry != head.about.end() && entry->is_string())
      kind = entry->get<std::string>();
    return Error{"seen"};
  };
  static_cast<void>(static_cast<bool>(TensorFile::read(path, look)));
  return kind;
}

}  // namespace

Result<Followable> followableAt(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code failed;
  if (stampOf(path).bytes == 0) {
    const fs::path folder = fs::absolute(path, failed).parent_path();
    if (!fs::is_directory(folder, failed))
      return fileError(path, fmt::format("there is no folder {} for it to come into.", folder.string()));
    const auto ends = [&](const char* ending) { return path.ends_with(ending); };
    const bool life = ends(".safetensors") || ends(".surefoot") || ends(".ckpt");
    return life ? Followable::Checkpoint : Followable::Store;
  }
  const auto head = readHead(path, 15);
  if (!head) return head.error();
  if (*head == "SQLite format 3") return Followable::Store;
  const std::string kind = kindOf(path);
  if (kind == "checkpoint") return Followable::Checkpoint;
  return fileError(path, kind == "q-function"
                             ? "it is a Q-function, which is written once; a life can begin with it (--load). What "
                               "can be followed is a store of results, or a checkpoint."
                             : "it is neither a store of results nor a checkpoint, so it cannot be followed.");
}

}  // namespace surefoot
