// SPDX-License-Identifier: GPL-3.0-or-later
// Texts as arguments of a command that a person copies into a shell.
#pragma once

#include <string>
#include <string_view>

namespace surefoot {

/// The text as one word of a POSIX shell: unchanged, or in single quotes if it contains characters that are special in
/// a shell (a blank, a quote, $, *; an umlaut is not special).
std::string shellQuoted(std::string_view text);

}  // namespace surefoot
