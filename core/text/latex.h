// SPDX-License-Identifier: GPL-3.0-or-later
// Text for LaTeX.
#pragma once

#include <string>
#include <string_view>

namespace surefoot {

/// Any text as plain LaTeX that shows the text and does nothing else. Characters that are commands are escaped. Letters
/// that are not ASCII are written with commands that need no package, ε as $\varepsilon$ and Ä as \"{A}; characters
/// without a command as their number, U+1F600.
std::string latexText(std::string_view text);

}  // namespace surefoot
