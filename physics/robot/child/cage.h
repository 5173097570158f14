// SPDX-License-Identifier: GPL-3.0-or-later
// The cage of a program: what it may see and use. With bubblewrap it has no network, sees the robot's folder, the
// system and the user's programs (cage_folders.h) read-only, nothing else of the folders where people keep files, and
// has a temporary folder of its own. Without, its memory, files and privileges are bounded all the same. Any thread.
#pragma once

#include <string>
#include <vector>

#include "core/basics/result.h"

namespace surefoot {

/// Whether bubblewrap is there and can make a cage on this machine. An error: it does not answer.
Result<bool> hasCage();

/// The whole command line for a program that is started in `folder`; the error says why it cannot be caged there.
Result<std::vector<std::string>> caged(const std::vector<std::string>& command, const std::string& folder,
                                       const std::string& modules);

/// Its environment, "NAME=value": the paths of programs and languages, nothing else.
std::vector<std::string> childEnvironment(const std::string& modules);

/// "in a cage: no network, …": for whoever is asked whether it may start.
const char* cageText();

}  // namespace surefoot
