// SPDX-License-Identifier: GPL-3.0-or-later
// Text from outside on its way to a terminal. Control characters and those that turn the direction of writing can make
// a terminal show something else than what the text says. Any thread.
#pragma once

#include <string>
#include <string_view>

namespace surefoot {

/// The text with such characters written as \x1b or \u202e, and bytes that are no UTF-8 as \xff. Line breaks and
/// tabulators stay. What JSON may hold in a string is written as JSON writes it, so JSON stays JSON.
std::string printable(std::string_view text);
/// Whether it is well-formed UTF-8: no overlong sequence, no surrogate, nothing beyond U+10FFFF.
bool isUtf8(std::string_view text);

}  // namespace surefoot
