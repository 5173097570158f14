// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/child/cage_folders.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "core/text/printable.h"
#include "core/text/text.h"

namespace surefoot {

namespace fs = std::filesystem;

namespace {

bool liesIn(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

class Shown {
 public:
  void add(const fs::path& path) {
    const bool hidden = std::any_of(hidden_.begin(), hidden_.end(),
                                    [&](const fs::path& folder) { return path != folder && liesIn(path, folder); });
    std::error_code error;
    if (hidden && fs::exists(path, error)) paths_.insert(path);
  }

  /// A folder of programs; beside "bin" lie the libraries of these.
  void addPrograms(const fs::path& programs) {
    const fs::path beside = programs.parent_path();
    add(programs);
    if (hidden_.contains(beside)) return;             // "~/bin" has the user's own files beside it
    if (programs.filename() == "shims") add(beside);  // they start what lies in other folders there
    if (programs.filename() != "bin") return;
    for (const char* part : {"lib", "lib64", "libexec", "pyvenv.cfg"}) add(beside / part);
  }

  /// Wherever its symbolic links lead.
  void addProgram(const fs::path& program) {
    std::error_code error;
    const fs::path real = fs::canonical(program, error);
    if (error || fs::is_directory(real, error)) return;
    if (real.parent_path().filename() == "bin") addPrograms(real.parent_path());
    add(real);
  }

  const std::set<fs::path>& paths() const { return paths_; }

 private:
  std::set<fs::path> hidden_ = hiddenFolders(), paths_;
};

}  // namespace

std::vector<fs::path> foldersIn(const char* variable) {
  std::vector<fs::path> folders;
  const char* value = std::getenv(variable);
  std::istringstream list(value ? value : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    std::error_code error;
    if (!fs::path(folder).is_absolute()) continue;
    if (const fs::path real = fs::canonical(folder, error); !error && fs::is_directory(real, error))
      folders.push_back(real);
  }
  return folders;
}

std::set<fs::path> hiddenFolders() {
  std::set<fs::path> folders;
  for (const char* folder : {"/tmp", "/var/tmp", "/run", "/home", "/root", "/mnt", "/media", "/srv"}) {
    std::error_code error;
    if (const fs::path real = fs::canonical(folder, error); !error && fs::is_directory(real, error))
      folders.insert(real);
  }
  for (const fs::path& home : foldersIn("HOME")) folders.insert(home);
  folders.erase("/");
  return folders;
}

std::set<fs::path> shownFolders(const std::string& program, const std::string& folder) {
  Shown shown;
  for (const fs::path& programs : foldersIn("PATH")) shown.addPrograms(programs);
  for (const char* variable : {"PYTHONPATH", "VIRTUAL_ENV", "CONDA_PREFIX", "PYENV_ROOT"})
    for (const fs::path& whole : foldersIn(variable)) shown.add(whole);
  for (const fs::path& home : foldersIn("HOME")) shown.add(home / ".local" / "lib");  // Python's packages of a user
  if (program.find('/') != std::string::npos)
    shown.addProgram(fs::path(folder) / program);
  else
    for (const fs::path& programs : foldersIn("PATH")) shown.addProgram(programs / program);
  return shown.paths();
}

Status checkCageFolder(const std::string& folder) {
  for (const fs::path& hidden : hiddenFolders())
    if (liesIn(hidden, folder))
      return Error{
          fmt::format("its folder, {}, cannot be shown to a program in a cage, for {} lies there. Put the robot and "
                      "its program into a folder of their own",
                      printable(shortened(folder)), hidden == fs::path(folder) ? "much else" : hidden.string())};
  return Done{};
}

}  // namespace surefoot
