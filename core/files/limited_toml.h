// SPDX-License-Identifier: GPL-3.0-or-later
// Counts levels in a TOML text from outside before it is parsed: the parser calls itself for every level, and it limits
// the nesting of values but not of keys with dots. Any thread.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/basics/result.h"

namespace surefoot {

inline constexpr int kDeepestToml = 32;                ///< levels of {} and [], and parts of a key: a.b.c has three
inline constexpr std::size_t kLongestToml = 4u << 20;  ///< [bytes]

/// Done, or an error that names the exceeded limit. It does not check whether the text is TOML.
Status checkTomlLimits(std::string_view text);

}  // namespace surefoot
