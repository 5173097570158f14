// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/c_policy/c_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace surefoot {

namespace {

/// "1" is an int in C, and 1/3 would be 0.
std::string withPoint(std::string text) {
  return text.find_first_of(".en") == text.npos ? text + ".0" : text;
}

template <class T, class Text>
std::string array(const std::string& type, const std::string& name, std::span<const T> values, const Text& text) {
  constexpr std::size_t kColumns = 118;
  std::string out = fmt::format("static const {} {}[{}] = {{", type, name, std::max<std::size_t>(values.size(), 1));
  std::size_t column = kColumns;
  for (const T& value : values) {
    const std::string number = text(value) + ",";
    if (column + number.size() >= kColumns) out += '\n', column = 0;
    out += number;
    column += number.size();
  }
  if (values.empty()) out += "0";
  return out + "};\n";
}

}  // namespace

std::string inC(double value) {
  return withPoint(fmt::format("{}", value));
}
std::string inC(float value) {
  return withPoint(fmt::format("{}", value)) + "f";
}

std::string arrayInC(const std::string& type, const std::string& name, std::span<const double> values) {
  return array(type, name, values, [](double v) { return inC(v); });
}
std::string floatArrayInC(const std::string& name, std::span<const double> values) {
  return array("float", name, values, [](double v) { return inC(static_cast<float>(v)); });
}
std::string arrayInC(const std::string& type, const std::string& name, std::span<const std::uint64_t> values) {
  return array(type, name, values, [](std::uint64_t v) { return fmt::format("{}u", v); });
}

std::string commentInC(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '/' && out.ends_with('*')) out += ' ';
    if (c == '*' && out.ends_with('/')) out += ' ';
    out += static_cast<unsigned char>(c) < 0x20 || c == '\\' ? ' ' : c;
  }
  return out;
}

}  // namespace surefoot
