// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a command line, in one sentence.
#pragma once

#include <string>

#include "core/basics/result.h"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace surefoot {

/// The first word that no option or command knows, with the nearest that one does. `train` has the options that people
/// write in front of a command.
Error unexpected(const CLI::App& app, const CLI::App& train, const std::string& word);

/// CLI11's error.
Error plain(const CLI::ParseError& error);

/// `--log --json` is a forgotten file name, not a file called "--json".
Status checkSwallowed(const CLI::App& command);

}  // namespace surefoot
