// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/handbook/written_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/files/read_file.h"
#include "core/handbook/handbook.h"

namespace surefoot {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kSection = "<!-- section: ", kInclude = "<!-- include: ", kEnd = " -->";

std::string takeLine(std::string& text) {
  const auto end = std::min(text.find('\n'), text.size());
  const std::string line = text.substr(0, end);
  text.erase(0, std::min(end + 1, text.size()));
  return line;
}

/// "03-the-world.md" is the page "the-world".
std::string nameOf(const fs::path& file) {
  const std::string stem = file.stem().string();
  const auto letter = stem.find_first_not_of("0123456789-");
  return letter == std::string::npos ? stem : stem.substr(letter);
}

/// What stands between such a beginning and the end of a comment; empty: the line is another one.
std::string within(const std::string& line, std::string_view begin) {
  if (!line.starts_with(begin) || !line.ends_with(kEnd)) return "";
  return line.substr(begin.size(), line.size() - begin.size() - kEnd.size());
}

}  // namespace

Result<HandbookPage> parsePage(const std::string& written, const std::string& file) {
  std::string text = written;
  const std::string section = within(takeLine(text), kSection), title = takeLine(text);
  const auto wrong = [&](const std::string& why) { return Error{fmt::format("{}: {}", file, why), ErrorKind::File}; };
  if (section.empty() || !title.starts_with("# "))
    return wrong(fmt::format("its first line is no \"{}…{}\", or its second no title.", kSection, kEnd));
  const auto sections = handbookSections();
  if (std::find(sections.begin(), sections.end(), section) == sections.end())
    return wrong(fmt::format("there is no section \"{}\".", section));
  HandbookPage page{.name = nameOf(file), .section = section, .title = title.substr(2), .text = {}};
  while (!text.empty()) {
    const std::string line = takeLine(text), other = within(line, kInclude);
    if (other.empty()) {
      page.text += line + "\n";
      continue;
    }
    auto included = readText((fs::path(file).parent_path() / other).string());
    if (!included) return included.error();
    static_cast<void>(takeLine(*included));  // its title
    page.text += *included;
  }
  return page;
}

Result<Handbook> writtenPages(const std::string& folder, const std::string& language) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".md") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  Handbook pages;
  for (const fs::path& english : files) {
    const fs::path inLanguage = english.parent_path() / language / english.filename();
    const fs::path& file = fs::is_regular_file(inLanguage, error) ? inLanguage : english;
    const auto text = readText(file.string());
    if (!text) return text.error();
    auto page = parsePage(*text, file.string());
    if (!page) return page.error();
    pages.push_back(std::move(*page));
  }
  if (pages.empty()) return Error{fmt::format("{}: the pages of the handbook are not there.", folder), ErrorKind::File};
  return pages;
}

}  // namespace surefoot
