// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/handbook/handbook.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/files/read_file.h"
#include "core/handbook/declared_pages.h"

namespace surefoot {

namespace fs = std::filesystem;

namespace {

/// In this order they are read.
constexpr const char* kSections[] = {"First steps", "The window",       "Lessons",  "Methods", "Worlds",   "Parameters",
                                     "Experiments", "Without a window", "Commands", "Files",   "Questions"};

std::size_t placeOf(const std::string& section) {
  return static_cast<std::size_t>(std::find(std::begin(kSections), std::end(kSections), section) - kSections);
}

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

}  // namespace

const HandbookPage* pageNamed(const Handbook& handbook, std::string_view name) {
  const auto page =
      std::find_if(handbook.begin(), handbook.end(), [&](const HandbookPage& p) { return p.name == name; });
  return page == handbook.end() ? nullptr : &*page;
}

std::string methodPage(std::string_view name) {
  return fmt::format("method-{}", name);
}
std::string commandPage(std::string_view name) {
  return fmt::format("command-{}", name);
}
std::string parameterPage(std::string_view key, std::string_view environment) {
  if (key.starts_with("environment.")) return fmt::format("world-{}#{}", environment, key);
  const std::string_view group = key.substr(0, key.find('.'));
  return fmt::format("parameters-{}#{}", group, key);
}

Result<HandbookPage> parsePage(const std::string& written, const std::string& file) {
  std::string text = written;
  const std::string first = takeLine(text), second = takeLine(text);
  constexpr std::string_view kBegin = "<!-- section: ", kEnd = " -->";
  if (!first.starts_with(kBegin) || !first.ends_with(kEnd) || !second.starts_with("# "))
    return Error{fmt::format("{}: its first line is no \"{}…{}\", or its second no title.", file, kBegin, kEnd),
                 ErrorKind::File};
  HandbookPage page{.name = nameOf(file), .section = {}, .title = second.substr(2), .text = std::move(text)};
  page.section = first.substr(kBegin.size(), first.size() - kBegin.size() - kEnd.size());
  if (placeOf(page.section) == std::size(kSections))
    return Error{fmt::format("{}: there is no section \"{}\".", file, page.section), ErrorKind::File};
  return page;
}

Result<Handbook> makeHandbook(const Registry& registry, const std::string& folder,
                              const std::vector<CommandHelp>& commands) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".md") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  Handbook handbook;
  for (const fs::path& file : files) {
    const auto text = readText(file.string());
    if (!text) return text.error();
    auto page = parsePage(*text, file.string());
    if (!page) return page.error();
    handbook.push_back(std::move(*page));
  }
  if (handbook.empty())
    return Error{fmt::format("{}: the pages of the handbook are not there.", folder), ErrorKind::File};
  for (Handbook& made :
       std::vector{methodPages(registry), worldPages(registry), parameterPages(registry), commandPages(commands)})
    std::move(made.begin(), made.end(), std::back_inserter(handbook));
  std::stable_sort(handbook.begin(), handbook.end(), [](const HandbookPage& a, const HandbookPage& b) {
    return placeOf(a.section) < placeOf(b.section);
  });
  return handbook;
}

std::vector<std::string> brokenLinks(const Handbook& handbook, const std::string& folder) {
  std::vector<std::string> broken;
  for (const HandbookPage& page : handbook)
    for (auto at = page.text.find("]("); at != std::string::npos; at = page.text.find("](", at + 1)) {
      const auto end = page.text.find(')', at);
      const std::string target = page.text.substr(at + 2, end - at - 2);
      if (target.starts_with("https://")) continue;
      const auto hash = target.find('#');
      const HandbookPage* to = hash == 0 ? &page : pageNamed(handbook, target.substr(0, hash));
      std::error_code error;
      const bool isFile = !to && fs::is_regular_file(fs::path(folder) / target, error);
      const bool there =
          isFile || (to && (hash == std::string::npos ||
                            to->text.find("<a name=\"" + target.substr(hash + 1) + "\">") != std::string::npos));
      if (!there) broken.push_back(page.name + ": " + target);
    }
  return broken;
}

}  // namespace surefoot
