// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/basics/version.h"

namespace surefoot {

namespace {

/// The text as it is meant: no character of it is a command to the formatter.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c == '\n' ? ' ' : c;
  return out;
}

/// A letter that is not ASCII becomes "\\[u2212]" inside the formatter.
std::size_t bytesOf(std::string_view text) {
  std::size_t bytes = 0;
  for (const char c : text) bytes += static_cast<unsigned char>(c) < 0x80 ? 1 : (c & 0x40) != 0 ? 8 : 0;
  return bytes;
}

std::string bolder(std::string_view text) {
  return text.empty() ? "" : "\\fB" + escaped(text) + "\\fR";
}

std::string slanted(std::string_view text) {
  return text.empty() ? "" : "\\fI" + escaped(text) + "\\fR";
}

std::string upper(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](unsigned char c) { return std::toupper(c); });
  return out;
}

}  // namespace

ManPage::ManPage(std::string_view name, int section, std::string_view date, std::string_view line) {
  text_ = fmt::format(
      ".\\\" Made by `surefoot manual` from what `surefoot --help` and `surefoot list` say.\n"
      ".TH {} {} {} \"Surefoot {}\" \"Surefoot\"\n",
      upper(name), section, date, kVersion);
  heading("Name");
  lines(fmt::format("{} - {}", name, line));
}

void ManPage::heading(std::string_view title) {
  text_ += ".SH " + upper(title) + "\n";
}

void ManPage::subheading(std::string_view title) {
  text_ += ".SS " + escaped(title) + "\n";
}

void ManPage::paragraph(std::string_view text) {
  const std::string last = text_.substr(text_.rfind('\n', text_.size() - 2) + 1);
  if (!last.starts_with(".S")) text_ += ".PP\n";
  lines(text);
}

void ManPage::synopsis(std::string_view bold, std::string_view rest) {
  if (text_.find(".SH SYNOPSIS\n") + 13 != text_.size()) text_ += ".br\n";
  text_ += bolder(bold) + (rest.empty() ? "" : " " + slanted(rest)) + "\n";
}

void ManPage::term(std::string_view bold, std::string_view rest, std::string_view text) {
  text_ += ".TP\n" + bolder(bold) + (rest.empty() || bold.empty() ? "" : " ") + slanted(rest) + "\n";
  lines(text);
}

void ManPage::below(std::string_view text) {
  text_ += ".br\n";
  lines(text);
}

/// In lines of at most 78 bytes, as formatters count them, none of which begins like a command.
void ManPage::lines(std::string_view text) {
  constexpr std::size_t kMost = 78;
  std::string line;
  const auto flush = [&] {
    if (line.empty()) return;
    if (line[0] == '.' || line[0] == '\'') line.insert(0, "\\&");
    text_ += line + "\n";
    line.clear();
  };
  const std::string all = escaped(text);
  for (std::size_t i = 0; i < all.size();) {
    const std::size_t begin = all.find_first_not_of(' ', i);
    if (begin == std::string::npos) break;
    i = std::min(all.find(' ', begin), all.size());
    const std::string word = all.substr(begin, i - begin);
    if (!line.empty() && bytesOf(line) + 1 + bytesOf(word) > kMost) flush();
    line += (line.empty() ? "" : " ") + word;
  }
  flush();
}

}  // namespace surefoot
