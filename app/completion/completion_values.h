// SPDX-License-Identifier: GPL-3.0-or-later
// The values of an option, or of a word without one.
#pragma once

#include "app/completion/completion.h"
#include "app/requests/declared_commands.h"

namespace surefoot {

/// An unfinished command line, as far as values depend on it.
struct UnfinishedLine {
  const Registry& registry;
  std::string command;
  std::vector<std::string> words;  ///< behind the command, without the one that is being written
  std::string written;             ///< what is there of the value
};

/// Whether something is offered for the option's value.
bool hasKnownValues(const std::string& command, const DeclaredOption& option);

/// Adds values; those that do not begin as written may be among them.
void offerValues(const UnfinishedLine& line, const DeclaredOption& option, Completions& into);

}  // namespace surefoot
