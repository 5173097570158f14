// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/read_file.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <new>

namespace surefoot {

Error fileError(const std::string& name, const std::string& sentence) {
  return Error{fmt::format("{}: {}", name, sentence), ErrorKind::File};
}

Result<std::string> readHead(const std::string& path, std::size_t most) {
  const auto refuse = [&](const char* why) { return fileError(path, fmt::format("it cannot be read: {}.", why)); };
  if (path.empty()) return Error{"the name of the file is empty; a path is needed.", ErrorKind::File};
  struct stat info {};
  if (stat(path.c_str(), &info) != 0) return refuse(std::strerror(errno));
  if (!S_ISREG(info.st_mode)) return refuse("it is not a regular file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!in) return refuse(std::strerror(errno));
  std::string bytes;
  try {
    bytes.resize(std::min(most, static_cast<std::size_t>(info.st_size)));
  } catch (const std::bad_alloc&) {
    return refuse("it is larger than the memory that is left");
  }
  const std::size_t got = std::fread(bytes.data(), 1, bytes.size(), in.get());
  if (std::ferror(in.get())) return refuse(std::strerror(errno));
  bytes.resize(got);
  return bytes;
}

Result<std::string> readFile(const std::string& path) {
  return readHead(path, std::numeric_limits<std::size_t>::max());
}

Result<std::string> readText(const std::string& path) {
  constexpr std::size_t kMost = 64u << 20;
  auto text = readHead(path, kMost + 1);
  if (text && text->size() > kMost)
    return fileError(path, "it cannot be read: a text of more than 64 MB is none of ours.");
  return text;
}

}  // namespace surefoot
