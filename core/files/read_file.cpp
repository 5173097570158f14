// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/read_file.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace surefoot {

Error fileError(const std::string& name, const std::string& sentence) {
  return Error{fmt::format("{}: {}", name, sentence), ErrorKind::File};
}

Result<std::string> readFile(const std::string& path) {
  const auto refuse = [&](const char* why) { return fileError(path, fmt::format("it cannot be read: {}.", why)); };
  if (path.empty()) return Error{"the name of the file is empty; a path is needed.", ErrorKind::File};
  struct stat info {};
  if (stat(path.c_str(), &info) != 0) return refuse(std::strerror(errno));
  if (!S_ISREG(info.st_mode)) return refuse("it is not a regular file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!in) return refuse(std::strerror(errno));
  std::string bytes(static_cast<std::size_t>(info.st_size), '\0');
  const std::size_t got = std::fread(bytes.data(), 1, bytes.size(), in.get());
  if (std::ferror(in.get())) return refuse(std::strerror(errno));
  bytes.resize(got);
  return bytes;
}

}  // namespace surefoot
