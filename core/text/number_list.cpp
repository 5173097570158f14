// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of numbers that a person types.
#include <fmt/format.h>

#include <algorithm>

#include "core/text/number_text.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

/// Whether the comma at `at` may separate thousands: one to three digits before it, exactly three behind it.
bool mayGroup(std::string_view text, std::size_t at) {
  std::size_t begin = at, end = at + 1;
  while (begin > 0 && isDigit(text[begin - 1])) --begin;
  while (end < text.size() && isDigit(text[end])) ++end;
  const std::size_t before = at - begin, behind = end - at - 1;
  if (before < 1 || before > 3 || behind != 3) return false;
  const char left = begin > 0 ? text[begin - 1] : ' ';
  if (left == '.' || left == 'e' || left == 'E') return false;
  return text[begin] != '0' || (left == ',' && before == 3 && mayGroup(text, begin - 1));
}

std::vector<std::string> splitAt(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    std::string_view part = text.substr(begin, end - begin);
    while (part.starts_with(' ')) part.remove_prefix(1);
    while (part.ends_with(' ')) part.remove_suffix(1);
    parts.emplace_back(part);
    begin = end + 1;
  }
  return parts;
}

/// A blank between two values, not one beside a comma.
bool hasBlankBetween(std::string_view text) {
  for (std::size_t at = 0; (at = text.find(' ', at)) != std::string_view::npos;) {
    const auto next = text.find_first_not_of(' ', at);
    if (text[at - 1] != ',' && text[next] != ',') return true;
    at = next;
  }
  return false;
}

}  // namespace

Result<std::vector<std::string>> splitList(std::string_view name, std::string_view given) {
  const std::string text = plainSigns(given);
  if (text.find(';') != std::string::npos) return splitAt(text, ';');
  const bool blanks = hasBlankBetween(text);
  const bool besideComma = text.find(", ") != std::string::npos || text.find(" ,") != std::string::npos;
  if (blanks && !besideComma) {
    std::vector<std::string> values = splitAt(text, ' ');
    std::erase(values, "");
    return values;
  }
  for (std::size_t comma = 0; (comma = text.find(',', comma)) != std::string::npos; ++comma) {
    if (!mayGroup(text, comma)) continue;
    std::size_t begin = comma, end = comma + 4;
    while (begin > 0 && isDigit(text[begin - 1])) --begin;
    while (end < text.size() && text[end] == ',' && mayGroup(text, end)) end += 4;
    std::string one = text.substr(begin, end - begin), several;
    for (const char c : one) several += c == ',' ? std::string("; ") : std::string(1, c);
    std::erase(one, ',');
    return Error{
        fmt::format("{}: \"{}\" can be read as the number {} or as the list {}; separate the values of a list "
                    "by ; or blanks.",
                    name, shortened(text.substr(begin, end - begin)), one, several)};
  }
  return splitAt(text, ',');
}

Result<std::vector<double>> parseNumbers(std::string_view name, std::string_view text) {
  const auto values = splitList(name, text);
  if (!values) return values.error();
  std::vector<double> numbers;
  for (const std::string& value : *values) {
    const auto number = parseNumber(fmt::format("{}, value {}", name, numbers.size() + 1), value);
    if (!number) return number.error();
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace surefoot
