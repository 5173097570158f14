// SPDX-License-Identifier: GPL-3.0-or-later
// What is counted before a TOML text from outside is parsed: the parser calls itself for every level, and it bounds the
// nesting of values but not of keys with dots. Any thread.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/basics/result.h"

namespace surefoot {

inline constexpr int kDeepestToml = 32;                ///< levels of {} and [], and parts of a key: a.b.c has three
inline constexpr std::size_t kLongestToml = 4u << 20;  ///< [bytes]

/// Done, or a sentence with what is too much. Whether the text is TOML at all is for the parser to say.
Status checkTomlLimits(std::string_view text);

}  // namespace surefoot
