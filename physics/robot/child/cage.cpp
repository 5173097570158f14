// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/child/cage.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>

#include "physics/robot/child/process.h"

namespace surefoot {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMostMemory = 4ull << 30, kLargestFile = 256ull << 20;  // [bytes]

std::optional<std::string> variable(const char* name) {
  const char* value = std::getenv(name);
  return value && *value ? std::optional<std::string>(value) : std::nullopt;
}

/// Where people keep their files, and programs their talk.
std::vector<fs::path> hiddenFolders() {
  std::vector<fs::path> folders = {"/tmp", "/var/tmp", "/run", "/home", "/root", "/mnt", "/media", "/srv"};
  if (const auto home = variable("HOME")) folders.emplace_back(*home);
  std::erase_if(folders, [](const fs::path& folder) {
    std::error_code error;
    return !fs::is_directory(folder, error) || fs::is_symlink(folder, error);
  });
  return folders;
}

bool isHidden(const fs::path& path) {
  const auto folders = hiddenFolders();
  return std::any_of(folders.begin(), folders.end(), [&](const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end() &&
           path != folder;
  });
}

/// The folders of a list such as PATH.
std::vector<fs::path> foldersIn(const char* name) {
  std::vector<fs::path> folders;
  std::istringstream list(variable(name).value_or(""));
  for (std::string folder; std::getline(list, folder, ':');)
    if (!folder.empty()) folders.emplace_back(folder);
  return folders;
}

/// Folders of a user's own programs and packages, which lie in folders that are hidden: "~/miniconda3" of
/// "~/miniconda3/bin" in PATH, and those that languages are told of.
std::vector<std::string> packageFolders() {
  const fs::path home = variable("HOME").value_or("/");
  std::vector<fs::path> folders = foldersIn("PYTHONPATH");
  for (const fs::path& bin : foldersIn("PATH")) folders.push_back(bin.parent_path() == home ? bin : bin.parent_path());
  for (const char* name : {"VIRTUAL_ENV", "CONDA_PREFIX"})
    if (const auto folder = variable(name)) folders.emplace_back(*folder);
  folders.push_back(home / ".local" / "lib");
  std::vector<std::string> there;
  std::error_code error;
  for (const fs::path& folder : folders)
    if (fs::is_directory(folder, error) && isHidden(folder)) there.push_back(folder.string());
  return there;
}

std::vector<std::string> bubblewrap(const std::string& folder, const std::string& modules) {
  std::vector<std::string> words = {
      "bwrap",  "--unshare-all", "--die-with-parent", "--new-session", "--ro-bind", "/", "/", "--dev", "/dev",
      "--proc", "/proc"};
  for (const fs::path& path : hiddenFolders()) words.insert(words.end(), {"--tmpfs", path.string()});
  std::vector<std::string> seen = packageFolders();
  seen.push_back(folder);
  std::error_code error;
  if (!modules.empty()) seen.push_back(fs::canonical(modules, error).string());
  for (const std::string& path : seen) words.insert(words.end(), {"--ro-bind", path, path});
  words.insert(words.end(), {"--chdir", folder, "--"});
  return words;
}

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

}  // namespace

bool hasCage() {
  static const bool can = [] {
    std::vector<std::string> words = limits();
    words.insert(words.end(), {"bwrap", "--unshare-all", "--die-with-parent", "--ro-bind", "/", "/", "true"});
    auto trial = Process::start(words, childEnvironment(""));
    if (!trial) return false;
    std::byte nothing{};
    static_cast<void>((*trial)->read(std::span(&nothing, 1), std::chrono::seconds(5)));
    return (*trial)->end() == "it ended with the exit code 0";
  }();
  return can;
}

std::vector<std::string> caged(const std::vector<std::string>& command, const std::string& folder,
                               const std::string& modules) {
  std::vector<std::string> words = limits();
  if (hasCage())
    for (std::string& word : bubblewrap(folder, modules)) words.push_back(std::move(word));
  else
    words.insert(words.end(), {"env", "--chdir=" + folder});
  words.insert(words.end(), command.begin(), command.end());
  return words;
}

std::vector<std::string> childEnvironment(const std::string& modules) {
  std::vector<std::string> all = {"LC_ALL=C.UTF-8", "PYTHONDONTWRITEBYTECODE=1", "OMP_NUM_THREADS=1"};
  for (const char* name : {"PATH", "HOME", "PYENV_ROOT", "VIRTUAL_ENV", "CONDA_PREFIX", "LD_LIBRARY_PATH"})
    if (const auto value = variable(name)) all.push_back(fmt::format("{}={}", name, *value));
  std::string path = modules;
  if (const auto own = variable("PYTHONPATH")) path += path.empty() ? *own : ":" + *own;
  if (!path.empty()) all.push_back("PYTHONPATH=" + path);
  return all;
}

const char* cageText() {
  return hasCage() ? "in a cage: without network; it can read its folder, the system and the folders of your "
                     "programs (PATH), and write to a temporary folder"
                   : "with your rights, for bubblewrap is not there to cage it";
}

}  // namespace surefoot
