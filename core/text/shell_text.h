// SPDX-License-Identifier: GPL-3.0-or-later
// Texts as arguments of a command that a person copies into a shell.
#pragma once

#include <string>
#include <string_view>

namespace surefoot {

/// The text as one word of a POSIX shell: as it is, or in single quotes where it holds anything that a shell reads
/// otherwise (a blank, a quote, $, *, an umlaut is none of them).
std::string shellQuoted(std::string_view text);

}  // namespace surefoot
