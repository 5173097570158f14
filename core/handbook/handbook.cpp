// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/handbook/handbook.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/handbook/declared_pages.h"
#include "core/handbook/html.h"
#include "core/handbook/html_links.h"
#include "core/handbook/written_pages.h"

namespace surefoot {

namespace {

constexpr const char* kSections[] = {"First steps", "The window",       "Panels",   "Lessons", "Your own robot",
                                     "Experiments", "Without a window", "Files",    kMethods,  kWorlds,
                                     kParameters,   kCommands,          "Questions"};

std::size_t placeOf(const std::string& section) {
  return static_cast<std::size_t>(std::find(std::begin(kSections), std::end(kSections), section) - kSections);
}

}  // namespace

std::span<const char* const> handbookSections() {
  return kSections;
}

const HandbookPage* pageNamed(const Handbook& handbook, std::string_view name) {
  const auto page =
      std::find_if(handbook.begin(), handbook.end(), [&](const HandbookPage& p) { return p.name == name; });
  return page == handbook.end() ? nullptr : &*page;
}

std::string methodPage(std::string_view name) {
  return fmt::format("method-{}", name);
}
std::string worldPage(std::string_view name) {
  return fmt::format("world-{}", name);
}
std::string commandPage(std::string_view name) {
  return fmt::format("command-{}", name);
}
std::string parameterPage(std::string_view key, std::string_view environment) {
  const std::string_view group = key.substr(0, key.find('.'));
  return group == "environment" ? fmt::format("{}#{}", worldPage(environment), key)
                                : fmt::format("parameters-{}#{}", group, key);
}

Result<Handbook> makeHandbook(const Registry& registry, const std::string& folder,
                              const std::vector<CommandHelp>& commands, const HandbookSpeech& speech) {
  auto handbook = writtenPages(folder, speech.code);
  if (!handbook) return handbook;
  for (Handbook& made : std::vector{methodPages(registry, speech), worldPages(registry, speech),
                                    parameterPages(registry, speech), commandPages(commands)})
    std::move(made.begin(), made.end(), std::back_inserter(*handbook));
  std::stable_sort(handbook->begin(), handbook->end(), [](const HandbookPage& a, const HandbookPage& b) {
    return placeOf(a.section) < placeOf(b.section);
  });
  for (HandbookPage& page : *handbook) page.section = speech.say(page.section);
  return handbook;
}

std::vector<std::string> brokenLinks(const Handbook& handbook, const std::string& pictures) {
  std::vector<std::string> broken;
  for (const HandbookPage& page : handbook) {
    const auto look = [&](std::string_view target, bool picture) {
      const std::string to(target);
      if (to.starts_with("https://")) return to;
      const auto hash = std::min(to.find('#'), to.size());
      const HandbookPage* other = hash == 0 ? &page : pageNamed(handbook, to.substr(0, hash));
      std::error_code error;
      const bool there =
          picture
              ? std::filesystem::is_regular_file(std::filesystem::path(pictures) / to, error)
              : other && (hash == to.size() ||
                          other->text.find(fmt::format("<a name=\"{}\">", to.substr(hash + 1))) != std::string::npos);
      if (!there) broken.push_back(page.name + ": " + to);
      return to;
    };
    static_cast<void>(withLinks(htmlOf(page), look));
  }
  return broken;
}

}  // namespace surefoot
