// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/robustness/value_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "core/text/number_text.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

/// "0..2:9"
Result<std::vector<double>> parseRange(const Parameter& parameter, std::string_view text, std::size_t dots) {
  const auto colon = text.find(':', dots);
  const auto refuse = [&](const char* why) {
    return Error{fmt::format("{}: \"{}\" {}; a range is FIRST..LAST:HOW MANY, such as 0..2:9.", parameter.key,
                             shortened(text), why)};
  };
  if (parameter.kind == Kind::Choice) return refuse("is a range, and these are no numbers");
  if (colon == std::string_view::npos) return refuse("does not say how many values");
  const auto first = parseNumber(parameter.key, text.substr(0, dots));
  if (!first) return first.error();
  const auto last = parseNumber(parameter.key, text.substr(dots + 2, colon - dots - 2));
  if (!last) return last.error();
  const auto count = parseWhole(parameter.key + ", how many", text.substr(colon + 1), 2, kMostValues);
  if (!count) return count.error();
  if (*first == *last) return refuse("ends where it begins");
  std::vector<double> values;
  for (std::uint64_t i = 0; i < *count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(*count - 1);
    const double value = i + 1 == *count ? *last : *first + share * (*last - *first);
    values.push_back(std::strtod(fmt::format("{:.12g}", value).c_str(), nullptr));
  }
  return values;
}

}  // namespace

Result<std::vector<double>> parseValues(const Parameter& parameter, std::string_view given) {
  const std::string text = plainSigns(given);
  std::vector<double> values;
  if (const auto dots = text.find(".."); dots != std::string::npos) {
    auto range = parseRange(parameter, text, dots);
    if (!range) return range;
    for (const double value : *range) {
      const auto allowed = checkValue(parameter, value);
      if (!allowed) return allowed.error();
      values.push_back(*allowed);
    }
  } else {
    const auto parts = splitList(parameter.key, text);
    if (!parts) return parts.error();
    for (const std::string& part : *parts) {
      const auto value = parseValue(parameter, part);
      if (!value) return value.error();
      values.push_back(*value);
    }
  }
  if (values.size() > kMostValues)
    return Error{
        fmt::format("{}: {} values are given; at most {} are allowed.", parameter.key, values.size(), kMostValues)};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::find(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(i), values[i]) !=
        values.begin() + static_cast<std::ptrdiff_t>(i))
      return Error{fmt::format("{}: the value {} is given twice; give it once.", parameter.key,
                               formatValue(parameter, values[i]))};
  return values;
}

Result<std::pair<double, double>> parseSpan(std::string_view name, std::string_view given) {
  const std::string text = plainSigns(given);
  const auto dots = text.find("..");
  const auto first = parseNumber(name, std::string_view(text).substr(0, dots));
  if (!first) return first.error();
  if (dots == std::string::npos) return std::pair{*first, *first};
  const auto last = parseNumber(name, std::string_view(text).substr(dots + 2));
  if (!last) return last.error();
  if (*last < *first)
    return Error{
        fmt::format("{}: \"{}\" ends before it begins; write the smaller number first.", name, shortened(text))};
  return std::pair{*first, *last};
}

}  // namespace surefoot
