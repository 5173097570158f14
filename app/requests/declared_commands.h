// SPDX-License-Identifier: GPL-3.0-or-later
// The commands and options as they are declared, as plain values: manual pages and completions are made from them.
#pragma once

#include <string>
#include <vector>

#include "app/requests/examples.h"
#include "core/registry.h"

namespace CLI {
class App;
}

namespace surefoot {

struct DeclaredOption {
  std::string name;         ///< "--set"; of a word without an option, "FILE"
  std::string letter{};     ///< "-h"; may be empty
  std::string type{};       ///< what it takes, "KEY=VALUE"; empty: nothing
  std::string usual{};      ///< what holds without it, where the help does not say it
  std::string help{};       ///< a sentence without its full stop
  bool positional = false;  ///< a word that stands alone
  bool repeats = false;     ///< it may be given several times
};

struct DeclaredCommand {
  std::string name;  ///< "train"; empty: the program itself
  std::string help;
  std::string remark{};  ///< what else stands below the options; may be empty
  std::vector<DeclaredOption> options{};
  std::vector<Example> examples{};
};

/// The program itself first, then its commands in the order of the help.
std::vector<DeclaredCommand> declaredCommands(const Registry& registry);

/// The same of a command line that is there.
std::vector<DeclaredCommand> declaredIn(const CLI::App& app);

}  // namespace surefoot
