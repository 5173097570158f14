// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "app/commands/commands.h"
#include "app/process/resources.h"
#include "core/lessons/lesson_check.h"
#include "core/lessons/lesson_library.h"
#include "core/lessons/lesson_reading.h"

namespace surefoot {

namespace {

constexpr std::uint64_t kSeed = 1;  // a student's, in lessons with a seed for each

int listLessons(const Registry& registry) {
  std::string text, chapter;
  for (const ShelvedLesson& one : lessonsIn(registry, resourceFolder("lessons"))) {
    if (!one.lesson) {
      text += fmt::format("  {}: it has an error; `surefoot lessons check` tells it\n", one.file());
      continue;
    }
    const Lesson& lesson = *one.lesson;
    if (lesson.chapter != chapter) text += fmt::format("{}{}\n", text.empty() ? "" : "\n", chapter = lesson.chapter);
    text += fmt::format("  {:>2} {:<36} {:>3.0f} min, level {}\n     {}\n", lesson.number, lesson.title, lesson.minutes,
                        lesson.level, lesson.line);
  }
  if (text.empty()) return fail({"lessons: they come with the program, and none were found beside it."});
  return print(text);
}

/// What is wrong in a lesson's file: when it is read, or when its solutions are lived through.
std::vector<Complaint> complaintsOf(const Registry& registry, const ShelvedLesson& one,
                                    std::vector<std::string>* texts) {
  std::vector<Complaint> all = one.complaints;
  if (!one.lesson) return all;
  const std::uint64_t seed = one.lesson->seedOfStudent ? kSeed : one.lesson->start.seed;
  for (Complaint& c : liveThrough(registry, *one.lesson, seed, texts)) all.push_back(std::move(c));
  return all;
}

Result<std::vector<ShelvedLesson>> lessonsNamed(const Registry& registry, const LessonsRequest& request) {
  if (request.words.size() == 1) return lessonsIn(registry, resourceFolder("lessons"));
  std::vector<ShelvedLesson> all;
  for (std::size_t i = 1; i < request.words.size(); ++i) {
    auto one = readLessonFile(registry, request.words[i]);
    if (!one) return one.error();
    all.push_back(std::move(*one));
  }
  return all;
}

int checkLessons(const Registry& registry, const LessonsRequest& request) {
  const auto lessons = lessonsNamed(registry, request);
  if (!lessons) return fail(lessons.error());
  std::size_t wrong = 0;
  for (const ShelvedLesson& one : *lessons) {
    std::vector<std::string> texts;
    const auto complaints = complaintsOf(registry, one, request.show ? &texts : nullptr);
    std::string text;
    for (const std::string& step : texts) text += step + "\n";
    wrong += !complaints.empty();
    for (const Complaint& c : complaints) text += complaintText(one.path, c) + "\n";
    if (complaints.empty())
      text += fmt::format("{}: well, {} steps lived through\n", one.path, one.lesson->steps.size());
    if (const int code = print(text); code != 0) return code;
  }
  if (lessons->empty()) return fail({"lessons: they come with the program, and none were found beside it."});
  return wrong == 0 ? 0 : fail({fmt::format("lessons: {} of {} need mending.", wrong, lessons->size())});
}

}  // namespace

int lessonsCommand(const Registry& registry, const LessonsRequest& request) {
  if (request.words.empty()) return listLessons(registry);
  if (request.words[0] == "check") return checkLessons(registry, request);
  return fail(
      {fmt::format("lessons: it takes check and the files of lessons, not \"{}\": `surefoot lessons check "
                   "FILE…`; without a word it lists the program's lessons.",
                   request.words[0])});
}

}  // namespace surefoot
