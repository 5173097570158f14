// SPDX-License-Identifier: GPL-3.0-or-later
// Text from outside on its way to a terminal. Control characters and characters that turn the direction of writing can
// make a terminal show something different from the text. Any thread.
#pragma once

#include <string>
#include <string_view>

namespace surefoot {

/// The text with control and direction characters written as \x1b or \u202e, and bytes that are no UTF-8 as \xff. Line
/// breaks and tabulators stay. Characters that JSON allows in a string are written as in JSON, so JSON stays JSON.
std::string printable(std::string_view text);
/// Whether it is well-formed UTF-8: no overlong sequence, no surrogate, nothing beyond U+10FFFF.
bool isUtf8(std::string_view text);

}  // namespace surefoot
