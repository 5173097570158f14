// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <vector>

namespace surefoot {

namespace {

Error unwritable(const std::string& what, const std::string& path, const std::string& why) {
  return Error{fmt::format("{}: {} cannot be written: {}.", what, path, why), ErrorKind::File};
}

std::string folderOf(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// The rights that the user's mask leaves a new file.
mode_t usualMode() {
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

/// Gives a file without a name the name ".surefoot-PID-N" in the folder; empty: it cannot be done.
std::string nameIn(const std::string& folder, int nameless) {
  constexpr int kMostTries = 1000;
  const std::string self = fmt::format("/proc/self/fd/{}", nameless);
  for (int i = 0; i < kMostTries; ++i) {
    std::string name = fmt::format("{}/.surefoot-{}-{}", folder, getpid(), i);
    if (linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) return name;
    if (errno != EEXIST) break;
  }
  return {};
}

/// Removes files that a killed program left under a temporary name. Their process must be gone, and they must be so old
/// that no program on another machine or in another container that shares the folder can still be using them.
void clearLitter(const std::string& folder) {
  constexpr auto kOld = std::chrono::hours(1);
  std::error_code failed;
  std::vector<std::filesystem::path> litter;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
    int process = 0, number = 0, length = 0;
    const std::string name = entry.path().filename().string();
    if (std::sscanf(name.c_str(), ".surefoot-%d-%d%n", &process, &number, &length) != 2) continue;
    if (static_cast<std::size_t>(length) != name.size() || process <= 0) continue;
    if (kill(process, 0) == 0 || errno != ESRCH) continue;
    std::error_code unknown;
    const auto written = entry.last_write_time(unknown);
    if (!unknown && std::filesystem::file_time_type::clock::now() - written > kOld) litter.push_back(entry.path());
  }
  for (const auto& file : litter) std::filesystem::remove(file, failed);
}

int openNameless(const std::string& folder) {
  return ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, usualMode());
}

/// Whether a file without a name can get one later: tried now with another, not found out after a night. Some file
/// systems have files without a name but no hard links; a bare chroot lacks /proc.
bool canBeNamedLater(const std::string& folder) {
  const int probe = openNameless(folder);
  if (probe < 0) return false;
  const std::string name = nameIn(folder, probe);
  if (!name.empty()) unlink(name.c_str());
  close(probe);
  return !name.empty();
}

}  // namespace

Result<WholeFile> WholeFile::createNew(const std::string& what, const std::string& path) {
  if (path.empty()) return Error{fmt::format("{}: the name of the file is empty; a path is needed.", what)};
  struct stat info {};
  if (lstat(path.c_str(), &info) == 0)
    return Error{fmt::format("{}: {} exists already; name a file that does not, or remove it first.", what, path),
                 ErrorKind::File};
  return open(what, path, false);
}

Result<WholeFile> WholeFile::createOrReplace(const std::string& what, const std::string& path) {
  if (path.empty()) return Error{fmt::format("{}: the name of the file is empty; a path is needed.", what)};
  struct stat info {};
  if (stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode))
    return unwritable(what, path, "it is there already, and not a regular file");
  std::error_code failed;
  const auto target = std::filesystem::canonical(path, failed);  // replaces the target of a link, not the link
  return open(what, failed ? path : target.string(), true);
}

Result<WholeFile> WholeFile::open(const std::string& what, const std::string& path, bool replaces) {
  struct stat info {};
  const std::string folder = folderOf(path);
  if (stat(folder.c_str(), &info) != 0)
    return unwritable(what, path, fmt::format("the folder {}: {}", folder, std::strerror(errno)));

  clearLitter(folder);
  // A file without a name, where the file system has such: whatever ends the program, nothing is left behind.
  if (canBeNamedLater(folder))
    if (const int nameless = openNameless(folder); nameless >= 0) return WholeFile(what, path, "", nameless, replaces);

  std::string temporary = folder + "/.surefoot-XXXXXX";
  const int named = mkostemp(temporary.data(), O_CLOEXEC);
  if (named < 0) return unwritable(what, path, std::strerror(errno));
  fchmod(named, usualMode());
  return WholeFile(what, path, std::move(temporary), named, replaces);
}

WholeFile::WholeFile(WholeFile&& other) noexcept
    : what_(std::move(other.what_)),
      path_(std::move(other.path_)),
      temporary_(std::move(other.temporary_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      replaces_(other.replaces_) {}

WholeFile::~WholeFile() {
  if (descriptor_ < 0) return;
  close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

// A name of its own first, then in one step the place of the old file. Whatever happens between, both are whole.
bool WholeFile::takePlace() const {
  const std::string name = temporary_.empty() ? nameIn(folderOf(path_), descriptor_) : temporary_;
  if (name.empty()) return false;
  if (rename(name.c_str(), path_.c_str()) == 0) return true;
  const int why = errno;
  unlink(name.c_str());
  errno = why;
  return false;
}

// Every way refuses to replace a file that has appeared meanwhile.
bool WholeFile::giveName() const {
  if (temporary_.empty()) {
    const std::string self = fmt::format("/proc/self/fd/{}", descriptor_);
    return linkat(AT_FDCWD, self.c_str(), AT_FDCWD, path_.c_str(), AT_SYMLINK_FOLLOW) == 0;
  }
  const char *from = temporary_.c_str(), *to = path_.c_str();
  if (renameat2(AT_FDCWD, from, AT_FDCWD, to, RENAME_NOREPLACE) == 0) return true;
  if (errno == EEXIST) return false;
  if (link(from, to) == 0) return unlink(from), true;
  if (errno == EEXIST) return false;
  // A file system that can do neither (SMB, exFAT): an empty file claims the name, and is replaced.
  const int claim = ::open(to, O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, usualMode());
  if (claim < 0) return false;
  close(claim);
  if (rename(from, to) == 0) return true;
  const int why = errno;
  unlink(to);
  errno = why;
  return false;
}

std::string WholeFile::openName() const {
  return temporary_.empty() ? fmt::format("/proc/{}/fd/{}", getpid(), descriptor_) : temporary_;
}

Status WholeFile::append(std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = write(descriptor_, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return unwritable(what_, path_, std::strerror(errno));
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return Done{};
}

Status WholeFile::commit(std::string_view content) {
  if (const Status s = append(content); !s) return s;
  if (fsync(descriptor_) != 0 || !(replaces_ ? takePlace() : giveName()))
    return unwritable(what_, path_, std::strerror(errno));
  close(std::exchange(descriptor_, -1));
  return Done{};
}

Status writeWhole(const std::string& what, const std::string& path, std::string_view content) {
  auto file = WholeFile::createOrReplace(what, path);
  if (!file) return file.error();
  return file->commit(content);
}

}  // namespace surefoot
