// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text.h"

#include <fmt/format.h>

namespace surefoot {

namespace {
std::string withMinus(std::string text) {
  if (!text.starts_with('-')) return text;
  const bool zero = text.find_first_of("123456789") == std::string::npos;
  return (zero ? "" : "\u2212") + text.substr(1);
}
}  // namespace

std::string fixedText(double value, int decimals) {
  return withMinus(fmt::format("{:.{}f}", value, decimals));
}

std::string countText(double value) {
  std::string text = fmt::format("{:.0f}", value);
  const std::size_t first = text.starts_with('-') ? 1 : 0;
  for (std::size_t i = text.size(); i > first + 3;) text.insert(i -= 3, ",");
  return withMinus(text);
}

std::string_view shortened(std::string_view text) {
  constexpr std::size_t kMost = 60;
  if (text.size() <= kMost) return text;
  std::size_t end = kMost;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // inside a UTF-8 character
  return text.substr(0, end);
}

std::string csvCell(std::string_view text) {
  bool formula = !text.empty() && std::string_view("=+-@\t\r\n").find(text[0]) != std::string_view::npos;
  for (const char* wide : {"＝", "＋", "－", "＠"}) formula = formula || text.starts_with(wide);
  const std::string safe = (formula ? "'" : "") + std::string(text);
  if (safe.find_first_of(",\"\r\n") == std::string::npos) return safe;
  std::string cell = "\"";
  for (const char c : safe) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

}  // namespace surefoot
