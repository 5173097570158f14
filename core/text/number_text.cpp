// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "core/text/text.h"

namespace surefoot {

namespace {

constexpr std::array<std::string_view, 10> kSuperscripts = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
constexpr std::string_view kRaisedMinus = "⁻";

bool allDigits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), isDigit);
}

void replaceAll(std::string& text, std::string_view what, std::string_view with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
}

void trim(std::string& text) {
  text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
  text.erase(text.find_last_not_of(' ') + 1);
}

/// Takes an exponent like "⁻⁶" from the end of a text and returns "-6"; "" if there is none.
std::string takeRaised(std::string& text) {
  std::string exponent;
  for (bool found = true; found;) {
    found = false;
    for (std::size_t digit = 0; digit < kSuperscripts.size(); ++digit)
      if (text.ends_with(kSuperscripts[digit])) {
        text.resize(text.size() - kSuperscripts[digit].size());
        exponent.insert(0, 1, static_cast<char>('0' + digit));
        found = true;
      }
  }
  if (exponent.empty() || !text.ends_with(kRaisedMinus)) return exponent;
  text.resize(text.size() - kRaisedMinus.size());
  return "-" + exponent;
}

/// "2 · 10⁻⁶", "2 × 10^-6" and "10⁻⁶" as "2e-6" and "1e-6".
void powerOfTen(std::string& text) {
  std::string head = text, exponent = takeRaised(head);
  if (const auto hat = text.rfind("10^"); exponent.empty() && hat != std::string::npos)
    head = text.substr(0, hat + 2), exponent = text.substr(hat + 3);
  if (exponent.empty() || !head.ends_with("10")) return;
  head.resize(head.size() - 2);
  trim(head);
  bool times = false;
  for (const std::string_view sign : {"·", "×", "*"})
    if (!times && head.ends_with(sign)) head.resize(head.size() - sign.size()), times = true;
  trim(head);
  if (head.empty() || head == "-")
    head += "1";
  else if (!times)
    return;
  text = head + "e" + exponent;
}

/// Digits in groups of three behind the first of one to three, "1,000,000": without the commas.
std::optional<std::string> ungrouped(std::string_view digits, char comma) {
  const auto first = digits.find(comma);
  if (first == std::string_view::npos || first < 1 || first > 3 || digits[0] == '0') return std::nullopt;
  if (!allDigits(digits.substr(0, first))) return std::nullopt;
  std::string plain(digits.substr(0, first));
  for (std::size_t at = first; at < digits.size(); at += 4) {
    const std::string_view group = digits.substr(at + 1, 3);
    if (digits[at] != comma || group.size() != 3 || !allDigits(group)) return std::nullopt;
    plain += group;
  }
  return plain;
}

/// "1,5" is 1.5 or 15, "1.000,5" is 1000.5 or 1.0005: how digits with a comma in the wrong place can be meant.
std::vector<std::string> readingsOf(const std::string& digits) {
  const auto comma = digits.find(',');
  const std::string before = digits.substr(0, comma), behind = digits.substr(comma + 1);
  if (!allDigits(behind)) return {};
  if (allDigits(before)) return {before + "." + behind, before + behind};
  const auto joined = ungrouped(before, '.');
  if (!joined) return {};
  std::string rest = before.substr(before.find('.') + 1) + behind;
  std::erase(rest, '.');
  return {*joined + "." + behind, before.substr(0, before.find('.')) + "." + rest};
}

/// A mantissa without its sign as digits and a point; "" if it is none, with the readings if there are some.
std::string mantissaOf(const std::string& text, std::vector<std::string>& readings) {
  if (const auto blank = text.find(' '); blank != std::string::npos) {
    const auto joined = ungrouped(text, ' ');
    if (joined) readings = {*joined, "the list " + text.substr(0, blank) + "; " + text.substr(blank + 1)};
    return "";
  }
  if (text.find(',') == std::string::npos) return text;
  const auto point = text.find('.');
  const std::string part = point == std::string::npos ? "" : text.substr(point);
  const auto joined = ungrouped(text.substr(0, point), ',');
  if (joined && part.find(',') == std::string::npos) return *joined + part;
  readings = readingsOf(text);
  return "";
}

}  // namespace

std::string plainSigns(std::string_view text) {
  std::string plain(text);
  replaceAll(plain, "\u2212", "-");
  for (const std::string_view blank : {"\u00a0", "\u202f", "\u2009", "\t"}) replaceAll(plain, blank, " ");
  trim(plain);
  return plain;
}

NumberText readNumberText(std::string_view given, std::string_view unit) {
  NumberText number;
  if (given.starts_with(' ') || given.ends_with(' ')) return number;
  std::string text = plainSigns(given);
  if (const std::string behind = plainSigns(unit); !behind.empty() && text.ends_with(behind))
    text.resize(text.size() - behind.size()), trim(text);
  powerOfTen(text);
  std::string sign;
  if (text.starts_with('-') || text.starts_with('+')) {
    if (text[0] == '-') sign = "-";
    text.erase(0, 1);
  }
  const auto e = text.find_first_of("eE");
  const std::string exponent = e == std::string::npos ? "" : text.substr(e);
  const std::string digits = mantissaOf(text.substr(0, e), number.readings);
  for (std::string& reading : number.readings) reading = sign + reading + exponent;
  if (digits.empty() || !(isDigit(digits[0]) || digits[0] == '.')) return number;
  number.plain = sign + digits + exponent;
  const char* const end = number.plain.data() + number.plain.size();
  const auto [last, code] = std::from_chars(number.plain.data(), end, number.value);
  number.good = code == std::errc{} && last == end && std::isfinite(number.value);
  return number;
}

std::string readingsText(const NumberText& number) {
  return fmt::format("can be read as {}; write the one that is meant", fmt::join(number.readings, " or as "));
}

Result<double> parseNumber(std::string_view name, std::string_view text) {
  const NumberText number = readNumberText(text);
  if (number.good) return number.value;
  if (!number.readings.empty())
    return Error{fmt::format("{}: \"{}\" {}.", name, shortened(text), readingsText(number))};
  return Error{fmt::format("{}: \"{}\" is not a finite decimal number.", name, shortened(text))};
}

Result<std::uint64_t> parseWhole(std::string_view name, std::string_view text, std::uint64_t low, std::uint64_t high) {
  const NumberText number = readNumberText(text);
  std::uint64_t value = 0;
  bool whole = false;
  if (number.good && allDigits(number.plain)) {
    const char* const end = number.plain.data() + number.plain.size();
    whole = std::from_chars(number.plain.data(), end, value).ec == std::errc{};
  }
  if (whole && value >= low && value <= high) return value;
  const std::string why = number.readings.empty() ? "is not allowed" : readingsText(number);
  return Error{
      fmt::format("{}: \"{}\" {}; it takes a whole number from {} to {}.", name, shortened(text), why, low, high)};
}

Result<std::uint64_t> parseSeed(std::string_view name, std::string_view text) {
  return parseWhole(name, text, 0, std::numeric_limits<std::uint64_t>::max());
}

std::string boundText(double value) {
  const std::string sign = value < 0 ? "\u2212" : "", shortest = fmt::format("{}", std::abs(value));
  const auto e = shortest.find('e');
  if (e != std::string::npos && (std::abs(value) >= 1e15 || std::abs(value) < 1e-6)) {
    std::string raised, exponent = shortest.substr(e + 1);
    for (const char c : exponent)
      if (c == '-')
        raised += kRaisedMinus;
      else if (isDigit(c) && !(c == '0' && (raised.empty() || raised == kRaisedMinus)))
        raised += kSuperscripts[static_cast<std::size_t>(c - '0')];
    const std::string mantissa = shortest.substr(0, e);
    return sign + (mantissa == "1" ? "" : mantissa + " · ") + "10" + raised;
  }
  std::string digits = fmt::format("{:.12f}", std::abs(value));
  digits.erase(digits.find_last_not_of('0') + 1);
  const auto point = digits.find('.');
  return sign + countText(std::floor(std::abs(value))) + (point + 1 < digits.size() ? digits.substr(point) : "");
}

}  // namespace surefoot
