// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the core for a reader of another language. The core writes English and knows no other: who shows a text
// gives the function.
#pragma once

#include <functional>
#include <string>

namespace surefoot {

/// The text in the language of its reader; a text that it does not know, as it is. Nothing: all stays English.
using Translate = std::function<std::string(const std::string& english)>;

/// What `translate` makes of a text; "" stays "".
inline std::string translated(const Translate& translate, const std::string& text) {
  return translate && !text.empty() ? translate(text) : text;
}

}  // namespace surefoot
