// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/shell_text.h"

#include <algorithm>

namespace surefoot {

namespace {
bool isPlain(unsigned char c) {
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c >= 0x80;
  const bool mark = std::string_view("_-./:,+@%").find(static_cast<char>(c)) != std::string_view::npos;
  return letter || mark || (c >= '0' && c <= '9');
}
}  // namespace

std::string shellQuoted(std::string_view text) {
  if (!text.empty() && std::all_of(text.begin(), text.end(), isPlain)) return std::string(text);
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace surefoot
