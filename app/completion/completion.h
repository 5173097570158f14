// SPDX-License-Identifier: GPL-3.0-or-later
// What may stand at the end of an unfinished command line: names, options, keys and values as they are declared. The
// shells ask by `surefoot complete WORD…` (resources/completions). Any thread.
#pragma once

#include <string>
#include <vector>

#include "core/registry.h"

namespace surefoot {

struct Completion {
  std::string word;    ///< the whole word; one that ends with "=" goes on
  std::string help{};  ///< in one line; may be empty
};

struct Completions {
  std::vector<Completion> words{};
  bool files = false;                  ///< names of files, too
  std::vector<std::string> endings{};  ///< of these files, "toml"; empty: of all
  bool folders = false;                ///< names of folders, too
};

/// `words`: those behind the program's name; the last is being written and may be empty.
Completions complete(const Registry& registry, const std::vector<std::string>& words);

/// For a shell, a line each: WORD, a tab and its help; ":files" and their endings; ":folders".
std::string completionsText(const Completions& completions);

}  // namespace surefoot
