// SPDX-License-Identifier: GPL-3.0-or-later
// A page of the handbook. A value.
#pragma once

#include <string>
#include <vector>

namespace surefoot {

struct HandbookPage {
  std::string name{};     ///< "first-steps"; links name it: [first steps](first-steps)
  std::string section{};  ///< "The window", in the language of the handbook
  std::string title{};    ///< "First steps"
  std::string text{};     ///< Markdown, without the title
};

/// All pages, in the order in which they are read; pages of a section follow each other.
using Handbook = std::vector<HandbookPage>;

/// By its name; nullptr: there is none.
const HandbookPage* pageNamed(const Handbook& handbook, std::string_view name);

}  // namespace surefoot
