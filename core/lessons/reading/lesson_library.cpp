// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/reading/lesson_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/files/read_file.h"
#include "core/lessons/reading/lesson_reading.h"
#include "core/text/printable.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

/// The names of lessons that a text links to: [the cliff](lesson:the-cliff).
std::vector<std::string> linksOf(const LessonText& text) {
  constexpr std::string_view kLink = "](lesson:";
  std::vector<std::string> names;
  for (const std::string& part : text.between)
    for (std::size_t at = part.find(kLink); at != std::string::npos; at = part.find(kLink, at + 1)) {
      const std::size_t from = at + kLink.size();
      names.push_back(part.substr(from, part.find(')', from) - from));
    }
  return names;
}

void checkLinks(ShelvedLesson& shelved, const std::set<std::string>& known) {
  const auto check = [&](const std::string& name, TextPlace at) {
    if (!known.contains(name))
      shelved.complaints.push_back({at, fmt::format("there is no lesson \"{}\" here.", printable(shortened(name)))});
  };
  for (const std::string& name : shelved.lesson->needs) check(name, {});
  for (const LessonStep& step : shelved.lesson->steps)
    for (const std::string& name : linksOf(step.say)) check(name, step.at);
}

}  // namespace

Result<ShelvedLesson> readLessonFile(const Registry& registry, const std::string& path, const Translate& translate) {
  const auto text = readText(path);
  if (!text) return text.error();
  ShelvedLesson shelved{.path = path};
  shelved.lesson = readLesson(registry, *text, path, shelved.complaints, translate);
  return shelved;
}

std::vector<ShelvedLesson> lessonsIn(const Registry& registry, const std::string& folder, const Translate& translate) {
  std::vector<ShelvedLesson> all;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".toml") continue;
    if (auto one = readLessonFile(registry, entry.path().string(), translate))
      all.push_back(std::move(*one));
    else
      all.push_back({entry.path().string(), std::nullopt, {{{}, one.error().message}}});
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  std::set<std::string> known;
  for (const ShelvedLesson& one : all)
    if (one.lesson) known.insert(one.lesson->name);
  for (ShelvedLesson& one : all)
    if (one.lesson) checkLinks(one, known);
  return all;
}

}  // namespace surefoot
