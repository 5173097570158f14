// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "app/commands/commands.h"
#include "core/files/read_file.h"
#include "core/lessons/lesson_life.h"
#include "core/lessons/lesson_reading.h"

namespace surefoot {

namespace {

/// What is wrong in a lesson's file: when it is read, or when its solutions are lived through.
Result<std::vector<Complaint>> complaintsOf(const Registry& registry, const std::string& file, std::size_t& steps) {
  constexpr std::uint64_t kSeed = 1;  // a student's, in lessons with a seed for each
  const auto text = readText(file);
  if (!text) return text.error();
  std::vector<Complaint> complaints;
  const auto lesson = readLesson(registry, *text, file, complaints);
  if (!lesson) return complaints;
  steps = lesson->steps.size();
  return liveThrough(registry, *lesson, kSeed);
}

}  // namespace

int lessonsCommand(const Registry& registry, const LessonsRequest& request) {
  if (request.words.size() < 2 || request.words[0] != "check")
    return fail({"lessons: it takes check and the files of lessons: `surefoot lessons check FILE…`."});
  std::size_t wrong = 0;
  std::string text;
  for (std::size_t i = 1; i < request.words.size(); ++i) {
    const std::string& file = request.words[i];
    std::size_t steps = 0;
    const auto complaints = complaintsOf(registry, file, steps);
    if (!complaints) return fail(complaints.error());
    wrong += !complaints->empty();
    for (const Complaint& c : *complaints) text += complaintText(file, c) + "\n";
    if (complaints->empty()) text += fmt::format("{}: well, {} steps lived through\n", file, steps);
  }
  if (const int code = print(text); code != 0) return code;
  if (wrong == 0) return 0;
  return fail({fmt::format("lessons: {} of {} need mending.", wrong, request.words.size() - 1)});
}

}  // namespace surefoot
