// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/child/cage_folders.h"

#include <fmt/format.h>
#include <unistd.h>

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

/// The folders of a variable, as they are written there.
std::vector<fs::path> namedIn(const char* variable) {
  std::vector<fs::path> folders;
  const char* value = std::getenv(variable);
  std::istringstream list(value ? value : "");
  for (std::string folder; std::getline(list, folder, ':');)
    if (std::error_code error; fs::path(folder).is_absolute() && fs::is_directory(folder, error))
      folders.emplace_back(folder);
  return folders;
}

class Showing {
 public:
  /// A folder or file, with the links on the way to it.
  void add(const fs::path& path) { addReal(follow(path)); }

  /// A folder of programs; beside "bin" lie the libraries of these.
  void addPrograms(const fs::path& path) {
    const fs::path programs = follow(path), beside = programs.parent_path();
    if (programs.empty()) return;
    addReal(programs);
    if (holdsHidden(beside)) return;                      // "~/bin" has the user's own files beside it
    if (programs.filename() == "shims") addReal(beside);  // they start what lies in other folders there
    if (programs.filename() != "bin") return;
    for (const char* part : {"lib", "lib64", "libexec", "pyvenv.cfg"})
      if (const fs::path real = follow(beside / part); liesIn(real, beside)) addReal(real);
  }

  /// And wherever its symbolic links lead.
  void addProgram(fs::path program) {
    constexpr int kMostLinks = 40;
    if (access(program.c_str(), X_OK) != 0) return;
    std::error_code error;
    for (int i = 0; i < kMostLinks; ++i) {
      if (program.parent_path().filename() == "bin") addPrograms(program.parent_path());
      add(program);
      if (!fs::is_symlink(program, error)) return;
      program = program.parent_path() / fs::read_symlink(program, error);
    }
  }

  ShownFolders take() {
    const auto covered = [&](const fs::path& path, bool itself) {
      return std::any_of(shown_.paths.begin(), shown_.paths.end(),
                         [&](const fs::path& folder) { return liesIn(path, folder) && (itself || path != folder); });
    };
    ShownFolders all;
    for (const fs::path& path : shown_.paths)
      if (!covered(path, false)) all.paths.insert(path);
    for (const auto& [link, target] : shown_.links)
      if (!covered(link, true)) all.links.emplace(link, target);
    return all;
  }

 private:
  bool isHidden(const fs::path& path) const {
    return std::any_of(hidden_.begin(), hidden_.end(),
                       [&](const fs::path& folder) { return path != folder && liesIn(path, folder); });
  }
  bool holdsHidden(const fs::path& path) const {
    return std::any_of(hidden_.begin(), hidden_.end(), [&](const fs::path& folder) { return liesIn(folder, path); });
  }
  void addReal(const fs::path& real) {
    std::error_code error;
    if (!real.empty() && isHidden(real) && !holdsHidden(real) && fs::exists(real, error)) shown_.paths.insert(real);
  }
  /// Where a path really lies; hidden links on the way are kept. Empty: nowhere.
  fs::path follow(const fs::path& path) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    if (error) return {};
    fs::path here;
    std::vector<fs::path> rest(path.begin(), path.end());
    std::reverse(rest.begin(), rest.end());
    while (!rest.empty()) {  // it ends, for the system has come to an end
      const fs::path next = rest.back();
      rest.pop_back();
      if (next == "..") here = here.parent_path();
      if (next == ".." || next == "." || next.empty()) continue;
      const fs::path at = here / next;
      if (!fs::is_symlink(at, error)) {
        here = at;
        continue;
      }
      const fs::path target = fs::read_symlink(at, error);
      if (isHidden(at)) shown_.links.emplace(at, target);
      const std::vector<fs::path> parts(target.begin(), target.end());
      rest.insert(rest.end(), parts.rbegin(), parts.rend());
      if (target.is_absolute()) here = "/";
    }
    return real;
  }

  std::set<fs::path> hidden_ = hiddenFolders();
  ShownFolders shown_;
};

}  // namespace

std::vector<fs::path> foldersIn(const char* variable) {
  std::vector<fs::path> folders;
  for (const fs::path& folder : namedIn(variable))
    if (std::error_code error; fs::exists(folder, error)) folders.push_back(fs::canonical(folder, error));
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

ShownFolders shownFolders(const std::string& program, const std::string& folder, const std::string& modules) {
  Showing showing;
  for (const fs::path& programs : namedIn("PATH")) showing.addPrograms(programs);
  for (const char* variable : {"PYTHONPATH", "VIRTUAL_ENV", "CONDA_PREFIX", "PYENV_ROOT", "LD_LIBRARY_PATH"})
    for (const fs::path& whole : namedIn(variable)) showing.add(whole);
  for (const fs::path& home : namedIn("HOME")) showing.add(home / ".local" / "lib");  // Python's packages of a user
  if (program.find('/') != std::string::npos)
    showing.addProgram(fs::path(folder) / program);
  else
    for (const fs::path& programs : namedIn("PATH")) showing.addProgram(programs / program);
  showing.add(folder);
  if (!modules.empty()) showing.add(modules);
  return showing.take();
}

Status checkCageFolders(const std::vector<std::string>& command, const std::string& folder, const ShownFolders& shown) {
  const std::set<fs::path> all = hiddenFolders();
  for (const fs::path& hidden : all)
    if (liesIn(hidden, folder))
      return Error{
          fmt::format("its folder, {}, cannot be shown to a program in a cage, for {} lies there. Put the robot and "
                      "its program into a folder of their own",
                      printable(shortened(folder)), hidden == fs::path(folder) ? "much else" : hidden.string())};
  for (const std::string& word : command) {
    std::error_code error;
    const fs::path file = fs::canonical(fs::path(folder) / word, error);
    if (error) continue;
    const auto holds = [&](const fs::path& other) { return liesIn(file, other); };
    if (std::any_of(all.begin(), all.end(), holds) && std::none_of(shown.paths.begin(), shown.paths.end(), holds))
      return Error{
          fmt::format("{} lies outside of its folder, {}, where a cage hides it. Put it beside the robot's file",
                      printable(shortened(word)), printable(shortened(folder)))};
  }
  return Done{};
}

}  // namespace surefoot
