// SPDX-License-Identifier: GPL-3.0-or-later
// Which folders a cage hides, and which of those that lie in them a program needs nevertheless. Any thread.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/basics/result.h"

namespace surefoot {

/// Where people keep their files, and programs their talk; without symbolic links, each before those that lie in it.
std::set<std::filesystem::path> hiddenFolders();

/// What is shown again of what is hidden.
struct ShownFolders {
  std::set<std::filesystem::path> paths;                         ///< folders and files; none lies in another
  std::map<std::filesystem::path, std::filesystem::path> links;  ///< symbolic links on the way to them
};

/// The robot's folder and that of modules; of languages and programs in PATH, and of the program itself, their parts
/// that run (bin, lib), for more is a user's own; the folders of PYTHONPATH, VIRTUAL_ENV, CONDA_PREFIX, PYENV_ROOT and
/// LD_LIBRARY_PATH. Never what holds a hidden folder.
ShownFolders shownFolders(const std::string& program, const std::string& folder, const std::string& modules);

/// Refuses a robot's folder that would show the program what the cage hides, and files of its command that the cage
/// hides from it.
Status checkCageFolders(const std::vector<std::string>& command, const std::string& folder, const ShownFolders& shown);

/// A variable of the environment with its folders, "~/bin:/usr/bin", without symbolic links; those that there are not
/// are left out.
std::vector<std::filesystem::path> foldersIn(const char* variable);

}  // namespace surefoot
