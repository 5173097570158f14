// SPDX-License-Identifier: GPL-3.0-or-later
// Out of a thread and out of a slot of Qt's nothing may be thrown: the program would end, and the life with it.
#pragma once

#include <exception>
#include <new>
#include <string>

namespace surefoot {

/// Calls f. Returns the exception that it throws, in one sentence; empty: none.
template <class F>
std::string troubleOf(F&& f) noexcept {
  try {
    f();
    return {};
  } catch (const std::bad_alloc&) {
    return "There is not enough memory for this; take fewer tiles, tilings or lives.";
  } catch (const std::exception& e) {
    return std::string("Something went wrong that should not: ") + e.what() + ".";
  } catch (...) {
    return "Something went wrong that should not.";
  }
}

}  // namespace surefoot
