// SPDX-License-Identifier: GPL-3.0-or-later
// What the program guarantees itself, checked in every build: not for input, which is refused with a sentence.
#pragma once

#include <stdexcept>
#include <string>

namespace surefoot {

[[noreturn, gnu::cold, gnu::noinline]] inline void failExpectation(const char* what, const char* file, int line) {
  throw std::logic_error(std::string(file) + ":" + std::to_string(line) + ": " + what);
}

/// Throws std::logic_error, with the place of the call, if the program is wrong; `what` says what should hold.
inline void expects(bool holds, const char* what, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  if (!holds) [[unlikely]]
    failExpectation(what, file, line);
}

}  // namespace surefoot
