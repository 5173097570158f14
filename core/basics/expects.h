// SPDX-License-Identifier: GPL-3.0-or-later
// What the program guarantees itself, checked in every build: not for input, which is refused with a sentence.
#pragma once

#include <source_location>
#include <stdexcept>
#include <string>

namespace surefoot {

[[noreturn, gnu::cold, gnu::noinline]] inline void failExpectation(const char* what, const std::source_location& at) {
  throw std::logic_error(std::string(at.file_name()) + ":" + std::to_string(at.line()) + ": " + what);
}

/// Throws std::logic_error if the program is wrong; `what` says what should hold.
inline void expects(bool holds, const char* what, const std::source_location& at = std::source_location::current()) {
  if (!holds) [[unlikely]]
    failExpectation(what, at);
}

}  // namespace surefoot
