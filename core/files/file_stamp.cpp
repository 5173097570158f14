// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_stamp.h"

#include <fmt/format.h>
#include <sys/stat.h>

namespace surefoot {

FileStamp stampOf(const std::string& path) {
  struct stat s {};
  if (stat(path.c_str(), &s) != 0) return {};
  return {fmt::format("{}:{}:{}:{}.{:09}", s.st_dev, s.st_ino, s.st_size, s.st_ctim.tv_sec, s.st_ctim.tv_nsec),
          s.st_size, s.st_mtim.tv_sec};
}

}  // namespace surefoot
