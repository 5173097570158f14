// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace surefoot {

Result<WholeFile> WholeFile::createNew(const std::string& what, const std::string& path) {
  if (path.empty()) return Error{fmt::format("{}: the name of the file is empty; a path is needed.", what)};
  struct stat info {};
  if (lstat(path.c_str(), &info) == 0)
    return Error{fmt::format("{}: {} exists already; name a file that does not, or remove it first.", what, path),
                 ErrorKind::File};
  std::string temporary = path + ".XXXXXX";
  const int descriptor = mkostemp(temporary.data(), O_CLOEXEC);
  if (descriptor < 0)
    return Error{fmt::format("{}: {} cannot be written: {}.", what, path, std::strerror(errno)), ErrorKind::File};
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(descriptor, 0666 & ~mask);
  return WholeFile(what, path, std::move(temporary), descriptor);
}

WholeFile::WholeFile(WholeFile&& other) noexcept
    : what_(std::move(other.what_)),
      path_(std::move(other.path_)),
      temporary_(std::move(other.temporary_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

WholeFile::~WholeFile() {
  if (descriptor_ < 0) return;
  close(descriptor_);
  unlink(temporary_.c_str());
}

Error WholeFile::failed(int code) const {
  return Error{fmt::format("{}: {} cannot be written: {}.", what_, path_, std::strerror(code)), ErrorKind::File};
}

Status WholeFile::commit(std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = write(descriptor_, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return failed(errno);
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  if (fsync(descriptor_) != 0) return failed(errno);
  if (renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, path_.c_str(), RENAME_NOREPLACE) != 0) {
    if (errno != EINVAL) return failed(errno);  // a file system that cannot say "do not replace"
    if (link(temporary_.c_str(), path_.c_str()) != 0) return failed(errno);
    unlink(temporary_.c_str());
  }
  close(std::exchange(descriptor_, -1));
  return Done{};
}

}  // namespace surefoot
