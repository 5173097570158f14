// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/child/program_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "core/basics/hash64.h"
#include "core/files/read_file.h"
#include "core/text/printable.h"

namespace surefoot {

std::uint64_t printOfFiles(const RobotSpec& spec, const std::string& folder) {
  constexpr std::size_t kMost = 16u << 20;  // [bytes]
  Hash64 hash;
  for (const std::string& word : spec.child.command)
    if (const auto file = readHead((std::filesystem::path(folder) / word).string(), kMost))
      hash.add(word), hash.add(*file);
  return hash.value();
}

std::string programOf(const RobotSpec& spec, const std::string& folder) {
  std::string program;
  for (const std::string& word : spec.child.command) program += fmt::format("{}:{} ", word.size(), word);
  return program + fmt::format("in {} with {:016x}", folder, printOfFiles(spec, folder));
}

std::string commandText(const RobotSpec& spec) {
  return printable(fmt::format("{}", fmt::join(spec.child.command, " ")));
}

}  // namespace surefoot
