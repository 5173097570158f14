// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as a person reads them: a true minus sign, thousands separated. For labels and messages, never for files.
#pragma once

#include <string>
#include <string_view>

namespace surefoot {

/// 0 … 9, whatever the locale.
constexpr bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// 3.14159, 2 → "3.14"; −0.001, 2 → "0.00"; never "−0".
std::string fixedText(double value, int decimals);

/// 1234567.0 → "1,234,567".
std::string countText(double value);

/// A text as a cell of a CSV table, in quotes where it needs them (RFC 4180). A text that a spreadsheet would take for
/// a formula, because it begins with = + - @, a tab or a line end, gets an apostrophe in front. Not for numbers.
std::string csvCell(std::string_view text);

/// The beginning of something that a person typed, for a message: at most 60 bytes, never half a character.
std::string_view shortened(std::string_view text);

}  // namespace surefoot
