// SPDX-License-Identifier: GPL-3.0-or-later
// Text for LaTeX.
#pragma once

#include <string>
#include <string_view>

namespace surefoot {

/// A text of any kind as plain LaTeX that shows it and does nothing else: letters that are commands are escaped, and
/// what is not ASCII is spelled with what LaTeX has without a package, ε as $\varepsilon$ and Ä as \"{A}. A character
/// that it has not stands as its number, U+1F600.
std::string latexText(std::string_view text);

}  // namespace surefoot
