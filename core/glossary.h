// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the program: everything that can be chosen by name, and the terms that stand in the window, each with a
// formula, a sentence or two, and where to read on. Shown by Help › Words, by tooltips and by `surefoot list`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace surefoot {

struct Word {
  std::string name;     ///< name in the registry, if it can be chosen; empty: a term
  std::string title;    ///< "ε-greedy"
  std::string formula;  ///< in plain text; empty where there is none
  std::string text;     ///< what it means
  std::string source;   ///< "thesis, section 4.1; Sutton & Barto 2018, section 2.2"
};

/// All of them: policies, learning rules, representations, environments, then terms.
const std::vector<Word>& glossary();

/// The word for an entry that can be chosen; nullptr: there is none, which a test forbids.
const Word* wordOf(std::string_view name);

/// Whether a text that someone looks for, in any case, stands in the word.
bool mentions(const Word& word, std::string_view text);

}  // namespace surefoot
