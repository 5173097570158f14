// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of C99 text.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace surefoot {

/// A number that a C compiler reads as the same double.
std::string inC(double value);
/// The same for a table of float.
std::string inC(float value);

/// "static const TYPE NAME[COUNT] = {…};", in lines of at most 120 columns. The file's own names and numbers alone.
std::string arrayInC(const std::string& type, const std::string& name, std::span<const double> values);
std::string floatArrayInC(const std::string& name, std::span<const double> values);
std::string arrayInC(const std::string& type, const std::string& name, std::span<const std::uint64_t> values);

/// A comment's text: nothing in it ends the comment, and every line is short.
std::string commentInC(const std::string& text);

}  // namespace surefoot
