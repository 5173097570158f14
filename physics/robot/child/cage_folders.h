// SPDX-License-Identifier: GPL-3.0-or-later
// Which folders a cage hides, and which of those that lie in them a program needs nevertheless. Any thread.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/basics/result.h"

namespace surefoot {

/// Where people keep their files, and programs their talk; without symbolic links, each before those that lie in it.
std::set<std::filesystem::path> hiddenFolders();

/// The folders and files that are shown again: of languages and programs in PATH their parts that run (bin, lib), for
/// more is a user's own; of the program itself likewise; the folders of PYTHONPATH, VIRTUAL_ENV, CONDA_PREFIX and
/// PYENV_ROOT whole.
std::set<std::filesystem::path> shownFolders(const std::string& program, const std::string& folder);

/// Refuses a robot's folder that would show the program what the cage hides.
Status checkCageFolder(const std::string& folder);

/// A variable of the environment with its folders, "~/bin:/usr/bin", without symbolic links; those that there are not
/// are left out.
std::vector<std::filesystem::path> foldersIn(const char* variable);

}  // namespace surefoot
