// SPDX-License-Identifier: GPL-3.0-or-later
// Pages of the handbook that are written by hand, a Markdown file each: "03-the-world.md" is the page "the-world". The
// first line says the section, the second the title; "<!-- include: ../robots/format.md -->" stands for the text of
// another file without its title.
#pragma once

#include "core/basics/result.h"
#include "core/handbook/page.h"

namespace surefoot {

/// All of a folder, by the numbers of their files; in a language, those of FOLDER/LANGUAGE in their place, as far as
/// they are there. An error names the file that cannot be read, and what is wrong.
Result<Handbook> writtenPages(const std::string& folder, const std::string& language = "en");

/// `file`: its name, and where what it includes is looked for.
Result<HandbookPage> parsePage(const std::string& text, const std::string& file);

}  // namespace surefoot
