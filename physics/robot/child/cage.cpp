// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/child/cage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <chrono>
#include <mutex>
#include <optional>

#include "physics/robot/child/cage_folders.h"
#include "physics/robot/child/process.h"

namespace surefoot {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMostMemory = 4ull << 30, kLargestFile = 256ull << 20, kSmallFolder = 16ull << 20;  // [bytes]
constexpr int kMostProcesses = 1024;  // and threads

std::vector<std::string> limits() {
  return {"setpriv",
          "--pdeathsig",
          "KILL",
          "--no-new-privs",
          "prlimit",
          "--core=0",
          fmt::format("--data={}", kMostMemory),
          fmt::format("--fsize={}", kLargestFile)};
}

/// Of an empty folder in memory.
void addEmpty(std::vector<std::string>& words, const std::string& folder, std::uint64_t size) {
  words.insert(words.end(), {"--size", std::to_string(size), "--tmpfs", folder});
}

std::vector<std::string> bubblewrap() {
  std::vector<std::string> words = {"bwrap",
                                    "--unshare-all",
                                    "--unshare-user",
                                    "--disable-userns",
                                    "--cap-drop",
                                    "ALL",
                                    "--die-with-parent",
                                    "--new-session",
                                    "--ro-bind",
                                    "/",
                                    "/",
                                    "--dev",
                                    "/dev",
                                    "--proc",
                                    "/proc"};
  if (geteuid() == 0) words.insert(words.end(), {"--ro-bind", "/proc/sys", "/proc/sys"});  // it is root's, even so
  addEmpty(words, "/dev/shm", kLargestFile);
  return words;
}

/// What is hidden, what of it is shown again, and that only a temporary folder and an empty home can be written to.
void addFolders(std::vector<std::string>& words, const ShownFolders& shown) {
  std::set<fs::path> writable;
  std::error_code error;
  writable.insert(fs::canonical("/tmp", error));
  for (const fs::path& home : foldersIn("HOME")) writable.insert(home);
  const std::set<fs::path> hidden = hiddenFolders();
  for (const fs::path& path : hidden) addEmpty(words, path.string(), path == "/tmp" ? kLargestFile : kSmallFolder);
  for (const auto& [link, target] : shown.links)
    words.insert(words.end(), {"--symlink", target.string(), link.string()});
  for (const fs::path& path : shown.paths) words.insert(words.end(), {"--ro-bind", path.string(), path.string()});
  for (const fs::path& path : hidden)
    if (!writable.contains(path)) words.insert(words.end(), {"--remount-ro", path.string()});
  words.insert(words.end(), {"--remount-ro", "/dev"});
}

/// Ends by itself, with 0 if a cage could be made.
Result<bool> tryCage() {
  constexpr std::chrono::seconds kPatience(20);
  std::vector<std::string> words = limits();
  for (std::string& word : bubblewrap()) words.push_back(std::move(word));
  words.emplace_back("true");
  auto trial = Process::start(words, childEnvironment(""));
  if (!trial) return false;
  std::byte nothing{};
  const auto read = (*trial)->read(std::span(&nothing, 1), Process::Clock::now() + kPatience);
  if (read == Process::Reading::TimedOut) return Error{"bubblewrap does not answer, so it cannot be caged"};
  return (*trial)->end() == "it ended with the exit code 0";
}

}  // namespace

Result<bool> hasCage() {
  static std::mutex mutex;
  static std::optional<bool> known;
  const std::lock_guard lock(mutex);
  if (known) return *known;
  const auto can = tryCage();
  if (can) known = *can;
  return can;
}

Result<std::vector<std::string>> caged(const std::vector<std::string>& command, const std::string& folder,
                                       const std::string& modules) {
  std::vector<std::string> words = limits();
  const auto cage = hasCage();
  if (!cage) return cage.error();
  if (*cage) {
    const ShownFolders shown = shownFolders(command.front(), folder, modules);
    if (const Status s = checkCageFolders(command, folder, shown); !s) return s.error();
    for (std::string& word : bubblewrap()) words.push_back(std::move(word));
    addFolders(words, shown);
    words.insert(words.end(), {"--chdir", folder, "--", "prlimit", fmt::format("--nproc={}", kMostProcesses)});
  } else {
    words.insert(words.end(), {"env", "--chdir=" + folder});
  }
  words.insert(words.end(), command.begin(), command.end());
  return words;
}

std::vector<std::string> childEnvironment(const std::string& modules) {
  std::vector<std::string> all = {"LC_ALL=C.UTF-8", "PYTHONDONTWRITEBYTECODE=1", "OMP_NUM_THREADS=1"};
  const auto add = [&](const char* name, const std::vector<fs::path>& folders) {
    std::vector<std::string> texts;
    for (const fs::path& folder : folders) texts.push_back(folder.string());
    if (!texts.empty()) all.push_back(fmt::format("{}={}", name, fmt::join(texts, ":")));
  };
  for (const char* name : {"PATH", "HOME", "PYENV_ROOT", "VIRTUAL_ENV", "CONDA_PREFIX", "LD_LIBRARY_PATH"})
    add(name, foldersIn(name));
  std::vector<fs::path> python = foldersIn("PYTHONPATH");
  if (!modules.empty()) python.insert(python.begin(), modules);
  add("PYTHONPATH", python);
  return all;
}

const char* cageText() {
  const auto cage = hasCage();
  return cage && *cage
             ? "in a cage: without network; it can read its folder, the system and your programs in PATH with "
               "their libraries, and write to a temporary folder"
             : "with your rights, for bubblewrap is not there to cage it";
}

}  // namespace surefoot
